// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair of one region, to look at before all is
// repaired.
#include "viewer/local_repair.h"

#include <Eigen/Geometry>

#include "inspect/inspection_colors.h"
#include "inspect/layer_builder.h"
#include "mesh/box_tree.h"
#include "mesh/cloud_access.h"
#include "viewer/mesh_part.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

namespace app {
namespace {

using pcl::OpenReason;
using pcl::repair::Decisions;
using pcl::repair::JunctionDecision;
using pcl::repair::LoopDecision;
using pcl::repair::LoopKey;
using pcl::repair::LoopWish;
using pcl::repair::ModelSurvey;

bool
isIn(const std::vector<std::size_t>& loops, std::size_t loop)
{
  return std::find(loops.begin(), loops.end(), loop) != loops.end();
}

/** \brief Why nothing has to be done; empty: something has. */
std::string
whyNothing(const Decisions& decisions,
           std::size_t chosen,
           const std::vector<std::size_t>& loops)
{
  const bool is_loop = chosen < decisions.loops.size();
  if (!is_loop && !decisions.junctions[chosen - decisions.loops.size()].join)
    return "Stays apart, as it is wanted.";
  for (const std::size_t loop : loops)
    if (decisions.loops[loop].wish == LoopWish::LEAVE_OPEN)
      return (is_loop ? "Stays open" : "Not joined: loop " + std::to_string(loop)) +
             (is_loop ? ", as it is wanted." : " is to stay open.");
  if (loops.size() > 1)
    return "";
  const LoopDecision& loop = decisions.loops[loops.front()];
  if (loop.wish == LoopWish::AUTO && loop.joined)
    return "Stays open: what it could be joined to is kept apart.";
  if (loop.wish == LoopWish::AUTO && loop.reason != OpenReason::NONE)
    return std::string("Stays open: ") + describe(loop.reason) + ".";
  return "";
}

/** \brief Around some loops, larger than they are by their diagonal on each side. */
Eigen::AlignedBox3d
boxAround(const ModelSurvey& survey, const std::vector<std::size_t>& loops)
{
  Eigen::AlignedBox3d box;
  for (const std::size_t loop : loops)
    for (const Eigen::Vector3d& point : survey.loops[loop].curve.points)
      box.extend(point);
  return pcl::ccaa::widened(box, box.diagonal().norm());
}

/** \brief The loop of a part that is a loop of the whole. */
std::size_t
findLoop(const LoopKey& key, const MeshPart& part, const std::vector<LoopKey>& keys)
{
  std::size_t found = pcl::repair::NONE;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (part.point_of[static_cast<std::size_t>(keys[k].point)] == key.point &&
        keys[k].edges == key.edges &&
        (found == pcl::repair::NONE ||
         (keys[k].center - key.center).squaredNorm() <
             (keys[found].center - key.center).squaredNorm()))
      found = k;
  return found;
}

/** \brief What is decided about some loops, as decisions about a part in which nothing
 * else changes. */
Decisions
decisionsAbout(const std::vector<std::size_t>& loops,
               const Decisions& decisions,
               const ModelSurvey& survey,
               const MeshPart& part,
               const ModelSurvey& survey_of_part)
{
  Decisions about;
  about.mesh = survey_of_part.mesh;
  std::vector<LoopKey> keys;
  for (const auto& loop : survey_of_part.loops)
    keys.push_back(keyOf(survey_of_part.model, loop));
  about.loops.resize(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    about.loops[k].key = keys[k];
    about.loops[k].wish = LoopWish::LEAVE_OPEN;
  }
  std::vector<std::size_t> places(decisions.loops.size(), pcl::repair::NONE);
  for (const std::size_t loop : loops) {
    places[loop] = findLoop(keyOf(survey.model, survey.loops[loop]), part, keys);
    if (places[loop] == pcl::repair::NONE)
      continue;
    LoopDecision& there = about.loops[places[loop]];
    there.wish = loops.size() == 1 ? LoopWish::CLOSE : decisions.loops[loop].wish;
    there.cap = decisions.loops[loop].cap;
  }
  for (JunctionDecision junction : decisions.junctions) {
    junction.first_loop = places[junction.first_loop];
    junction.second_loop = places[junction.second_loop];
    if (std::max(junction.first_loop, junction.second_loop) != pcl::repair::NONE)
      about.junctions.push_back(junction);
  }
  return about;
}

/** \brief As of the whole, as far as it can be told for a part. */
RepairTask
taskForPart(const RepairTask& task, const ModelSurvey& survey, bool joins)
{
  RepairTask part{task.method, nullptr, task.threads};
  auto& parameters = part.method.survey;
  parameters.decisions = nullptr;
  parameters.dropped = {};
  parameters.orientation.sides = {};
  if (parameters.field.near <= 0.0)
    parameters.field.near = survey.spacing;
  const double diagonal = diagonalOf(survey.model);
  for (pcl::repair::Extent* limit :
       {&parameters.greatest_bridge, &part.method.filling.greatest_length})
    *limit = limit->length(diagonal);
  part.method.join_islands = joins;
  return part;
}

/** \brief New triangles, each with points of its own, in the colours of their origins.
 */
InspectionLayer
showPatches(const pcl::PolygonMesh& mesh, const pcl::RepairReport& report)
{
  LayerBuilder builder("patches", "");
  const pcl::ccaa::PointView points = pcl::ccaa::positionView(mesh.cloud);
  for (std::size_t t = 0; t < report.origins.size(); ++t) {
    if (report.origins[t] == pcl::TriangleOrigin::INPUT)
      continue;
    std::vector<pcl::index_t> corners;
    for (const pcl::index_t corner : mesh.polygons[t].vertices)
      corners.push_back(
          builder.addPoint(Eigen::Vector3d(points[static_cast<std::size_t>(corner)]),
                           colorOf(report.origins[t])));
    builder.addFace(corners);
  }
  return builder.finish("");
}

/** \brief What became of the holes along some points of the part. */
std::string
tell(const pcl::RepairReport& report, const std::set<pcl::index_t>& points)
{
  std::size_t open = 0;
  std::string reason;
  for (const pcl::RepairedHole& hole : report.holes)
    if (hole.open != OpenReason::NONE && points.count(hole.point) > 0) {
      ++open;
      reason = describe(hole.open);
    }
  if (!report.finished)
    return "Stopped.";
  if (report.new_triangles == 0)
    return reason.empty() ? "Nothing is to be closed here."
                          : "Stays open: " + reason + ".";
  const std::string closed =
      "Closed by " + std::to_string(report.new_triangles) + " triangles";
  return open == 0 ? closed + "."
                   : closed + "; " + std::to_string(open) + " open: " + reason + ".";
}

/** \brief Points of a part on some loops of the whole. */
std::set<pcl::index_t>
pointsOn(const std::vector<std::size_t>& loops,
         const ModelSurvey& survey,
         const MeshPart& part)
{
  std::set<pcl::index_t> points;
  for (const std::size_t loop : loops)
    for (const pcl::index_t vertex : survey.loops[loop].vertices)
      points.insert(part.pointFor(
          survey.model.point_of_vertex[static_cast<std::size_t>(vertex)]));
  return points;
}

} // namespace

std::vector<std::size_t>
regionOf(const Decisions& decisions, std::size_t chosen)
{
  if (chosen >= decisions.loops.size()) {
    const auto& junction = decisions.junctions[chosen - decisions.loops.size()];
    return {junction.first_loop, junction.second_loop};
  }
  std::vector<std::size_t> loops{chosen};
  for (const JunctionDecision& junction : decisions.junctions) {
    const std::size_t other = junction.first_loop == chosen    ? junction.second_loop
                              : junction.second_loop == chosen ? junction.first_loop
                                                               : chosen;
    if (junction.join && !isIn(loops, other) &&
        decisions.loops[other].wish != LoopWish::LEAVE_OPEN)
      loops.push_back(other);
  }
  return loops;
}

LocalRepair
repairLocally(const RepairTask& task,
              const ModelSurvey& survey,
              const Decisions& decisions,
              std::size_t chosen)
{
  const std::vector<std::size_t> loops = regionOf(decisions, chosen);
  LocalRepair local;
  local.told = whyNothing(decisions, chosen, loops);
  if (!local.told.empty())
    return local;
  MeshPart part = cutPart(survey.model, boxAround(survey, loops));
  RepairTask task_for_part = taskForPart(task, survey, loops.size() > 1);
  ProgressBar no_bar(true);
  RepairTask quick = task_for_part;
  quick.method.survey.trace_between_islands = false;
  quick.method.survey.trace_in_holes = false;
  task_for_part.method.survey.decisions =
      std::make_shared<const Decisions>(decisionsAbout(
          loops, decisions, survey, part, surveyMesh(quick, {}, no_bar, part.mesh)));
  if (part.free_points.width > 0)
    task_for_part.free_points = &part.free_points;
  pcl::RepairReport report;
  const std::set<pcl::index_t> points = pointsOn(loops, survey, part);
  repairMesh(task_for_part, {}, no_bar, part.mesh, report);
  local.told = tell(report, points);
  local.triangles = report.new_triangles;
  local.patches = showPatches(part.mesh, report);
  return local;
}

} // namespace app
