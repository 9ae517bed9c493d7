// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one repair, from the mesh as it comes to the triangles that
// are new.

#include "repair/repair_run.h"

#include "icadm/model_assembly.h"
#include "mesh/cloud_access.h"
#include "repair/darning_choice.h"
#include "repair/hole_list.h"
#include "repair/last_check.h"
#include "repair/loop_reasons.h"
#include "repair/repair_log.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** Times that what came out is looked at again. What one pass leaves open because of
 * its neighbours, the next one finds alone. */
constexpr int MOST_PASSES = 5;

/** Name of the stage for people; \a pass counts from 0. */
std::string
closingStage(int pass)
{
  return pass == 0 ? "closing"
                   : "closing, pass " + std::to_string(pass + 1) + " of at most " +
                         std::to_string(MOST_PASSES);
}

/** Where a region is built: its boundary with room around it. */
ccaa::Box
placeOf(const std::vector<HolePolygon>& holes)
{
  ccaa::Box box;
  for (const HolePolygon& hole : holes)
    for (const Position& point : hole.curve.points)
      box.extend(point);
  const Eigen::Vector3d room = Eigen::Vector3d::Constant(box.diagonal().norm());
  return {box.min() - room, box.max() + room};
}

bool
hasFloatPositions(const pcl::PCLPointCloud2& cloud)
{
  return std::any_of(cloud.fields.begin(), cloud.fields.end(), [](const auto& field) {
    return field.name == "x" && field.datatype == pcl::PCLPointField::FLOAT32;
  });
}

/** Why a hole stayed open. */
struct Failure {
  OpenReason open = OpenReason::NONE;
  std::size_t tries = 0;
};

/** The cap of holes that are closed together. */
Cap
capOf(const HoleList& list, const std::vector<std::size_t>& holes, Cap usual)
{
  const auto cap_of = [&](std::size_t hole) {
    const Cap cap = list.holes[hole].cap;
    return cap == Cap::AUTO ? usual : cap;
  };
  const bool all_flat = std::all_of(holes.begin(), holes.end(), [&](std::size_t hole) {
    return cap_of(hole) == Cap::FLAT;
  });
  if (all_flat)
    return Cap::FLAT;
  const bool is_loop = holes.size() == 1 && list.holes[holes.front()].loop != NONE;
  return is_loop ? cap_of(holes.front()) : Cap::SMOOTH;
}

/** What comes to a model. */
struct Addition {
  Triangles triangles;
  Positions positions;
  std::vector<pcl::index_t> point_of_vertex;
};

template <typename T>
void
append(const std::vector<T>& more, std::vector<T>& list)
{
  list.insert(list.end(), more.begin(), more.end());
}

void
append(const Addition& more, IncompleteModel& model)
{
  append(more.triangles, model.triangles);
  append(more.positions, model.positions);
  append(more.point_of_vertex, model.point_of_vertex);
}

class RepairRun {
public:
  RepairRun(const RepairParameters& parameters,
            const ccaa::LoopContext& context,
            RepairReport& report)
  : parameters_(parameters)
  , closes_all_(parameters.watertight || parameters.darning.close == CloseChoice::ALL)
  , context_(context)
  , report_(report)
  , log_(survey_, report)
  {
    if (closes_all_)
      parameters_.darning.close = CloseChoice::HOLES;
    parameters_.survey.simple_edges = simpleEdges(parameters.darning);
    parameters_.survey.trace_in_holes = false;
    parameters_.survey.trace_between_islands = parameters.join_islands;
  }

  RepairedModel
  run(const pcl::PolygonMesh::ConstPtr& mesh, const pcl::PCLPointCloud2* free_points);

private:
  using Clock = RepairLog::Clock;

  bool
  runPasses();
  bool
  closeHoles(const std::string& stage);
  HoleList
  list() const;
  bool
  allIsClosed() const;
  bool
  isOpen() const;
  void
  fixLimits();
  void
  beginClosingAll();
  void
  takeBack(Triangles triangles);
  void
  takeAdded();
  void
  finish();
  void
  accept(const std::vector<std::size_t>& holes,
         ClosedRegion closed,
         SurfaceObstacle& obstacle);
  void
  addPatch(const Patch& patch, const std::vector<std::size_t>& reported);
  void
  resurvey();
  void
  reportLeftOpen();
  void
  report(const OpenHole& hole, const HoleOutcome& outcome);
  HoleOutcome
  lastOutcome(const OpenHole& hole) const;

  RepairParameters parameters_; /**< as they are in the present pass */
  bool closes_all_;             /**< once nothing more can be joined */
  ccaa::LoopContext context_;
  RepairReport& report_;
  ModelSurvey survey_;
  RepairLog log_;
  bool float_positions_ = true;
  RepairedModel result_;
  HoleList list_;                                    /**< of the last pass */
  std::unordered_map<pcl::index_t, Failure> failed_; /**< of a hole at a vertex */
  std::vector<bool> used_; /**< of each free point: it is a vertex now */
  Addition added_;         /**< by this pass */
};

/** All boundaries and which of them are to be closed. */
HoleList
RepairRun::list() const
{
  HoleList list = listHoles(survey_, parameters_.darning);
  const bool keeps_apart =
      !parameters_.join_islands && survey_.model.islands.size() > 1;
  for (OpenHole& hole : list.holes)
    if (keeps_apart && couldBeJoined(hole.open))
      hole.open = OpenReason::NOT_WANTED;
  return list;
}

/** One pass. \return whether anything was closed */
bool
RepairRun::closeHoles(const std::string& stage)
{
  const auto tell = [&](double share) {
    if (context_.control != nullptr)
      context_.control->report(stage.c_str(), share);
  };
  tell(0.0);
  list_ = list();
  Triangles given = list_.replaced.empty() ? Triangles() : survey_.model.triangles;
  if (!list_.replaced.empty())
    weldPinches(list_.replaced, context_, survey_.model);
  std::vector<Region> regions;
  std::vector<ccaa::Box> places;
  for (const std::vector<std::size_t>& holes : list_.regions) {
    Region region;
    region.bridge_vertices = list_.bridge_vertices;
    for (const std::size_t hole : holes)
      region.holes.push_back(list_.holes[hole].polygon);
    region.cap = capOf(list_, holes, parameters_.darning.cap);
    places.push_back(placeOf(region.holes));
    regions.push_back(std::move(region));
  }
  SurfaceObstacle obstacle(survey_.model, places);
  added_ = {};
  log_.beginPass();
  failed_.clear();
  used_.assign(survey_.model.free_points.size(), false);
  const SurveyGuides none;
  const ClosingPlace place{survey_.model,
                           survey_.guides ? *survey_.guides : none,
                           parameters_,
                           float_positions_,
                           report_.reading.global_shift};
  for (std::size_t r = 0; r < regions.size() && !context_.cancelled(); ++r) {
    accept(
        list_.regions[r], closeRegion(place, regions[r], obstacle, context_), obstacle);
    tell(static_cast<double>(r + 1) / static_cast<double>(regions.size()));
  }
  const bool closed_any = !added_.triangles.empty();
  if (!closed_any && !list_.replaced.empty())
    takeBack(std::move(given));
  return closed_any;
}

/** The model without welded points. */
void
RepairRun::takeBack(Triangles triangles)
{
  IncompleteModel& model = survey_.model;
  model.triangles = std::move(triangles);
  model.adjacency.build(
      model.triangles, model.positions.size(), context_.threads, context_.control);
  list_.replaced.clear();
}

/** What this pass closed becomes part of the model. Holes that meet in a point and
 * stayed open get vertices of their own there again. */
void
RepairRun::takeAdded()
{
  append(added_, survey_.model);
  added_ = {};
  if (list_.replaced.empty())
    return;
  const std::vector<pcl::index_t> number = separatePinches(context_, survey_.model);
  list_.replaced.clear();
  const auto of_input =
      number.begin() + static_cast<std::ptrdiff_t>(result_.input_vertices);
  result_.input_vertices -=
      static_cast<std::size_t>(std::count(number.begin(), of_input, pcl::UNAVAILABLE));
  std::unordered_map<pcl::index_t, Failure> failed;
  for (const auto& [vertex, failure] : failed_)
    failed.emplace(number[static_cast<std::size_t>(vertex)], failure);
  failed_ = std::move(failed);
}

void
RepairRun::accept(const std::vector<std::size_t>& holes,
                  ClosedRegion closed,
                  SurfaceObstacle& obstacle)
{
  std::vector<std::size_t> reported(holes.size(), NONE);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const OpenHole& hole = list_.holes[holes[i]];
    if (closed.holes[i].open == OpenReason::NONE) {
      reported[i] = log_.add(hole, closed.holes[i]);
      continue;
    }
    for (const pcl::index_t vertex : hole.polygon.vertices)
      if (static_cast<std::size_t>(vertex) < survey_.model.positions.size())
        failed_[vertex] = {closed.holes[i].open, closed.holes[i].tries};
  }
  obstacle.add(closed.patch.positions, closed.patch.triangles);
  addPatch(closed.patch, reported);
}

void
RepairRun::addPatch(const Patch& patch, const std::vector<std::size_t>& reported)
{
  std::vector<pcl::index_t> number = patch.rim;
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v) {
    number.push_back(static_cast<pcl::index_t>(survey_.model.positions.size() +
                                               added_.positions.size()));
    added_.positions.push_back(patch.positions[v]);
    const std::size_t free_point = patch.free_point[v];
    const bool is_own = free_point != NONE && !used_[free_point];
    if (is_own) // of two patches at one free point the later one gets a copy
      used_[free_point] = true;
    added_.point_of_vertex.push_back(
        is_own ? survey_.model.point_of_free_point[free_point] : pcl::UNAVAILABLE);
  }
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    Triangle triangle = patch.triangles[t];
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
    added_.triangles.push_back(triangle);
    log_.addTriangle(reported[patch.hole[t]]);
  }
}

/** The model with all patches, and what is to be told about it. */
void
RepairRun::resurvey()
{
  takeAdded();
  IncompleteModel& before = survey_.model;
  IncompleteModel model =
      assembleModel(std::move(before.triangles), std::move(before.positions), context_);
  model.point_of_vertex = std::move(before.point_of_vertex);
  for (std::size_t i = 0; i < used_.size(); ++i)
    if (!used_[i]) {
      model.free_points.push_back(before.free_points[i]);
      model.point_of_free_point.push_back(before.point_of_free_point[i]);
    }
  LoopWishes wishes = std::move(survey_.wishes);
  survey_ = surveyModel(
      std::move(model), survey_.sight, parameters_.survey, context_, std::move(wishes));
  used_.assign(survey_.model.free_points.size(), false);
}

/** What the last try said, or else what speaks against one. */
HoleOutcome
RepairRun::lastOutcome(const OpenHole& hole) const
{
  HoleOutcome outcome;
  outcome.open = hole.open;
  if (hole.open != OpenReason::NONE)
    return outcome;
  outcome.open = OpenReason::NO_DARN;
  for (const pcl::index_t vertex : hole.polygon.vertices) {
    const auto failure = failed_.find(vertex);
    if (failure == failed_.end())
      continue;
    outcome.open = failure->second.open;
    outcome.tries = failure->second.tries;
    break;
  }
  return outcome;
}

/** Nothing is left that another look could find. */
bool
RepairRun::allIsClosed() const
{
  return failed_.empty() &&
         std::none_of(list_.holes.begin(), list_.holes.end(), [](const OpenHole& hole) {
           return isShortfall(hole.open);
         });
}

/** Anything at all is left that can be closed. */
bool
RepairRun::isOpen() const
{
  return !failed_.empty() ||
         std::any_of(list_.holes.begin(), list_.holes.end(), [](const OpenHole& hole) {
           return hole.open != OpenReason::NONE && hole.open != OpenReason::ONE_SIDED;
         });
}

/** Shares of the diagonal are those of the input's. */
void
RepairRun::fixLimits()
{
  const double diagonal = diagonalOf(survey_.model);
  for (Extent* limit :
       {&parameters_.darning.greatest_length, &parameters_.survey.greatest_bridge})
    *limit = Extent(limit->length(diagonal));
}

/** Nothing more can be joined: from now on each boundary is closed by itself. */
void
RepairRun::beginClosingAll()
{
  parameters_.darning.close = CloseChoice::ALL;
  parameters_.survey.trace_between_islands = false;
  resurvey();
}

/** Close what is open, look again, until nothing comes of it any more. \return whether
 * all is closed */
bool
RepairRun::runPasses()
{
  for (int pass = 0; pass < MOST_PASSES && !context_.cancelled(); ++pass) {
    const auto start = Clock::now();
    const bool closed_any = closeHoles(closingStage(pass));
    log_.countSeconds("closing", start);
    const bool finished = allIsClosed();
    if (!closed_any || finished || context_.cancelled())
      return finished;
    const auto closed = Clock::now();
    resurvey();
    log_.countSeconds("looking again", closed);
  }
  return false;
}

/** The end where all is closed: no need to put the new model in order. */
void
RepairRun::finish()
{
  report_.counts_after.islands = list_.islands;
  report_.class_after = classOf(report_.counts_after);
  for (const OpenHole& hole : list_.holes)
    if (hole.open != OpenReason::NONE) {
      HoleOutcome outcome;
      outcome.open = hole.open;
      report(hole, outcome);
    }
  takeAdded();
}

void
RepairRun::report(const OpenHole& hole, const HoleOutcome& outcome)
{
  RepairedHole& entry = report_.holes[log_.add(hole, outcome)];
  entry.shortfall = parameters_.watertight ? outcome.open != OpenReason::NONE
                                           : isShortfall(outcome.open);
  report_.shortfalls += entry.shortfall ? 1 : 0;
}

void
RepairRun::reportLeftOpen()
{
  report_.counts_after = survey_.counts;
  report_.class_after = survey_.icm_class;
  survey_.joined.bridges.clear(); // they led to nothing
  survey_.joined.holes = {};
  for (const OpenHole& hole : list().holes)
    report(hole, lastOutcome(hole));
}

RepairedModel
RepairRun::run(const pcl::PolygonMesh::ConstPtr& mesh,
               const pcl::PCLPointCloud2* free_points)
{
  survey_ = surveyModel(mesh, free_points, parameters_.survey, context_);
  report_.reading = survey_.reading;
  if (!survey_.reading.problem.empty() || survey_.cancelled)
    return {};
  float_positions_ = hasFloatPositions(mesh->cloud);
  result_.input_vertices = survey_.model.positions.size();
  result_.input_triangles = survey_.model.triangles.size();
  fixLimits();
  log_.noteInput();
  bool finished = runPasses();
  if (closes_all_ && isOpen() && !context_.cancelled()) {
    beginClosingAll();
    finished = runPasses();
  }
  if (context_.cancelled())
    return {};
  if (finished)
    finish();
  else
    reportLeftOpen();
  result_.model = std::move(survey_.model);
  const auto closed = Clock::now();
  if (!proveManifold(context_, result_, report_)) {
    if (!context_.cancelled())
      report_.reading.problem = "the result would be no manifold, by a fault of ours";
    return {};
  }
  log_.countSeconds("last check", closed);
  report_.new_triangles = result_.model.triangles.size() - result_.input_triangles;
  return std::move(result_);
}

/** Bridges are told in the frame of the cloud. */
void
moveBridges(const Eigen::Vector3d& shift, std::vector<RepairBridge>& bridges)
{
  if (shift.isZero(0.0))
    return;
  for (RepairBridge& bridge : bridges)
    for (Position& point : bridge.points)
      point += shift;
}

} // namespace

RepairedModel
runRepair(const pcl::PolygonMesh::ConstPtr& mesh,
          const pcl::PCLPointCloud2* free_points,
          const RepairParameters& parameters,
          const ccaa::LoopContext& context,
          RepairReport& report)
{
  report = RepairReport();
  RepairedModel repaired =
      RepairRun(parameters, context, report).run(mesh, free_points);
  moveBridges(report.reading.global_shift, report.bridges);
  report.cancelled = context.cancelled();
  return repaired;
}

} // namespace repair
} // namespace pcl
