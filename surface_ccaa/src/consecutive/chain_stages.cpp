// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of a chain: starts, filters, base.
#include <pcl/console/print.h>

#include "consecutive/chain.h"
#include "consecutive/filter_stage.h"
#include "consecutive/stage_polygons.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace pcl {
namespace ccaa {

/** One start algorithm and the filter behind it. A step that makes internal points
 * fewer is taken back. */
bool
Chain::applyStart(std::size_t number)
{
  report_.stages.emplace_back();
  ChainStageReport& stage = report_.stages.back();
  stage.name = startName(number);
  std::vector<Vertices> made;
  if (!construct(number, made))
    return false;
  if (number > 0 && made.empty()) {
    run_.weight_done += FILTER_WEIGHT;
    stage.internal_points = report_.internal_points;
    return true;
  }
  ChainMesh given = joined(number, std::move(made));
  ChainMesh left;
  if (!filterTriangles(given, left))
    return false;
  stage.internal_points = countInternalPoints(left.roles);
  stage.kept = number == 0 || stage.internal_points >= report_.internal_points;
  if (!stage.kept)
    return true;
  report_.internal_points = stage.internal_points;
  report_.connected_points = countConnectedPoints(left.roles);
  run_.current = std::move(left);
  return true;
}

/** What the filter is to judge: the triangles there are and those just made. */
ChainMesh
Chain::joined(std::size_t number, std::vector<Vertices> made) const
{
  ChainMesh given = run_.current;
  if (number == 0) {
    given.labels.assign(made.size(), 0);
    given.mesh->polygons = std::move(made);
    return given;
  }
  given.mesh = std::make_shared<PolygonMesh>(*run_.current.mesh);
  keepOnly(input_.starts[number]->keptTriangles(), given);
  appendNewTriangles(
      made, static_cast<std::uint8_t>(number), given.mesh->polygons, given.labels);
  return given;
}

/** What the start algorithm adds, as triangles. */
bool
Chain::construct(std::size_t number, std::vector<Vertices>& made)
{
  ChainStageReport& stage = report_.stages.back();
  StageProgress progress = run_.beginStage(stage.name, START_WEIGHT);
  if (!progress.report(0))
    return false;
  const StageClock clock;
  const ChainPart& part = *input_.starts[number];
  const ScopedSettings scoped(part.runSettings(), input_.threads, progress);
  const ScopedSides sides(part.sideSettings(), run_.sides);
  if (!constructFrom(number, made))
    return false;
  report_.invalid_polygons += makeTriangles(made, run_.point_count, run_.loop());
  stage.seconds = clock.seconds();
  report_.start_seconds += stage.seconds;
  if (number == 0 && made.empty() && !cancelled())
    PCL_WARN("[pcl::ConsecutiveReconstruction::performReconstruction] the start "
             "algorithm made no triangle (%zu points)\n",
             run_.points.usable->size());
  return progress.report(1);
}

/** A completion is given the mesh there is, another algorithm the points that are still
 * open. */
bool
Chain::constructFrom(std::size_t number, std::vector<Vertices>& made)
{
  ChainPart& part = *input_.starts[number];
  if (part.completes()) {
    const auto partial_mesh = number == 0 ? nullptr : run_.current.mesh;
    if (!complete(partial_mesh, part, made))
      return false;
    if (partial_mesh) {
      const auto* kept = part.keptTriangles();
      const auto count = kept ? kept->size() : partial_mesh->polygons.size();
      made.erase(made.begin(), made.begin() + std::ptrdiff_t(count));
    }
    return true;
  }
  ChainSelection selection;
  selection.chosen = number == 0 ? run_.points.usable : selectOpenPoints(run_);
  selection.is_part = number > 0 || run_.points.is_selection;
  selection.has_gaps = run_.points.skipped > 0;
  if (selection.chosen->size() >= 3 && part.construct(selection, made))
    mapToCloud(*selection.chosen, made);
  return true;
}

bool
Chain::filterTriangles(ChainMesh& given, ChainMesh& left)
{
  StageProgress progress = run_.beginStage("filter", FILTER_WEIGHT);
  if (!progress.report(0))
    return false;
  const std::size_t given_count = given.labels.size();
  const StageClock clock;
  const ScopedSettings scoped(
      dynamic_cast<RunSettings*>(input_.filter), input_.threads, progress);
  const ScopedSides sides(dynamic_cast<SideSettings*>(input_.filter), run_.sides);
  const bool is_sound = applyFilter(given, input_.filter, run_, left);
  if (!is_sound)
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] the filter "
              "returned what it was not given (%zu triangles given, %zu polygons "
              "returned)\n",
              given_count,
              left.mesh->polygons.size());
  ChainStageReport& stage = report_.stages.back();
  stage.filter_seconds = clock.seconds();
  report_.filter_seconds += stage.filter_seconds;
  if (sides.tally() != nullptr)
    result_.sides = *sides.tally();
  return is_sound && progress.report(1);
}

bool
Chain::applyBase()
{
  ChainMesh& current = run_.current;
  ChainPart* const base = input_.base.get();
  // Who may replace triangles can cut a one-sided region; who keeps them all cannot.
  const bool is_one_sided = base != nullptr && base->keptTriangles() == nullptr &&
                            leftOneSided(input_.filter);
  if (is_one_sided)
    PCL_WARN("[pcl::ConsecutiveReconstruction::performReconstruction] not completed: a "
             "region is one-sided (%zu triangles)\n",
             current.labels.size());
  if (base != nullptr && !is_one_sided) {
    report_.stages.emplace_back();
    report_.stages.back().name = "base";
    std::vector<Vertices> polygons;
    if (!runBase(current.mesh, BASE_WEIGHT, polygons))
      return false;
    takeOver(std::move(polygons),
             base->keptTriangles(),
             static_cast<std::uint8_t>(input_.starts.size()),
             current);
    report_.stages.back().seconds = report_.base_seconds;
  }
  const std::size_t connected = countConnectedPoints(current.roles);
  report_.free_points = report_.points - std::min(report_.points, connected);
  return true;
}

/** The base algorithm, in the chain or alone; its time goes to base_seconds. */
bool
Chain::runBase(const PolygonMeshConstPtr& partial_mesh,
               double weight,
               std::vector<Vertices>& polygons)
{
  StageProgress progress = run_.beginStage("base", weight);
  if (!progress.report(0))
    return false;
  const StageClock clock;
  ChainPart& base = *input_.base;
  const ScopedSettings scoped(base.runSettings(), input_.threads, progress);
  const ScopedSides sides(base.sideSettings(), run_.sides);
  if (!complete(partial_mesh, base, polygons))
    return false;
  result_.sides = *sides.tally();
  report_.base_seconds = clock.seconds();
  return progress.report(1);
}

/** \return whether the completion kept to the contract of MeshCompletion */
bool
Chain::complete(const PolygonMeshConstPtr& partial_mesh,
                ChainPart& completion,
                std::vector<Vertices>& polygons) const
{
  completion.complete(partial_mesh, run_.points.usable, polygons);
  if (cancelled())
    return false;
  if (areTriangles(polygons, run_.point_count, run_.loop()) &&
      (!partial_mesh ||
       keepsTriangles(
           partial_mesh->polygons, completion.keptTriangles(), polygons, run_.loop())))
    return true;
  PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] the algorithm of "
            "stage '%s' did not keep the given triangles (%zu given, %zu polygons "
            "returned)\n",
            run_.stage.c_str(),
            partial_mesh ? partial_mesh->polygons.size() : 0,
            polygons.size());
  return false;
}

} // namespace ccaa
} // namespace pcl
