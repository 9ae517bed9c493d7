// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair, stage by stage.

#include "repair/repair_method.h"

#include "repair/filling_choice.h"
#include "repair/hole_closing.h"
#include "repair/last_check.h"
#include "repair/loop_reasons.h"
#include "run/stage_clock.h"
#include "survey/survey_stages.h"

#include <algorithm>
#include <string>
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

bool
closesAll(const RepairParameters& parameters)
{
  return parameters.watertight || parameters.filling.close == CloseChoice::ALL;
}

/** What is done first, and, where all is to be closed, what once nothing more can be
 * joined: then each boundary is closed by itself. Shares of the diagonal are those of
 * the input's. */
std::vector<RepairParameters>
roundsFor(const RepairParameters& wanted, double diagonal)
{
  RepairParameters first = wanted;
  first.survey.simple_edges = simpleEdges(wanted.filling);
  first.survey.trace_in_holes = false;
  first.survey.trace_between_islands = wanted.join_islands;
  for (Extent* limit : {&first.filling.greatest_length, &first.survey.greatest_bridge})
    *limit = Extent(limit->length(diagonal));
  if (!closesAll(wanted))
    return {first};
  first.filling.close = CloseChoice::HOLES;
  RepairParameters second = first;
  second.filling.close = CloseChoice::ALL;
  second.survey.trace_between_islands = false;
  return {first, second};
}

CloudFrame
frameOf(const pcl::PCLPointCloud2& cloud, const ReadingReport& reading)
{
  const bool has_floats =
      std::any_of(cloud.fields.begin(), cloud.fields.end(), [](const auto& field) {
        return field.name == "x" && field.datatype == pcl::PCLPointField::FLOAT32;
      });
  return {has_floats, reading.global_shift};
}

/** All boundaries, and which of them are to be closed. */
HoleList
holesOf(const ModelSurvey& survey, const RepairParameters& parameters)
{
  HoleList list = listHoles(survey, parameters.filling);
  if (!parameters.join_islands && survey.model.islands.size() > 1)
    for (OpenHole& hole : list.holes)
      if (couldBeJoined(hole.open))
        hole.open = OpenReason::NOT_WANTED;
  return list;
}

/** Nothing is left that another look could find. */
bool
allIsClosed(const HoleList& list, const ClosedHoles& closed)
{
  return closed.failed.empty() &&
         std::none_of(list.holes.begin(), list.holes.end(), [](const OpenHole& hole) {
           return isShortfall(hole.open);
         });
}

/** Anything at all is left that can be closed. */
bool
isOpen(const HoleList& list, const ClosedHoles& closed)
{
  return !closed.failed.empty() ||
         std::any_of(list.holes.begin(), list.holes.end(), [](const OpenHole& hole) {
           return hole.open != OpenReason::NONE && hole.open != OpenReason::ONE_SIDED;
         });
}

/** What the last try said, or else what speaks against one. */
HoleOutcome
lastOutcome(const OpenHole& hole, const ClosedHoles& closed)
{
  HoleOutcome outcome;
  outcome.open = hole.open;
  if (hole.open != OpenReason::NONE)
    return outcome;
  outcome.open = OpenReason::NO_FILLING;
  for (const pcl::index_t vertex : hole.polygon.vertices) {
    const auto failure = closed.failed.find(vertex);
    if (failure == closed.failed.end())
      continue;
    outcome.open = failure->second.open;
    outcome.tries = failure->second.tries;
    break;
  }
  return outcome;
}

/** One pass: the holes that were listed, and what came of it. */
struct Pass {
  HoleList holes;
  ClosedHoles closed;
  bool finished = false; /**< nothing is left that should be closed */
  const RepairParameters* parameters = nullptr; /**< that it went by */
};

void
reportOpen(const OpenHole& hole, const Pass& last, RepairLog& log, RepairReport& report)
{
  const HoleOutcome outcome = lastOutcome(hole, last.closed);
  RepairedHole& entry = report.holes[log.add(hole, outcome)];
  entry.shortfall = last.parameters->watertight ? outcome.open != OpenReason::NONE
                                                : isShortfall(outcome.open);
  report.shortfalls += entry.shortfall ? 1 : 0;
}

/** What stays open, and why. */
void
reportEnd(const Pass& last, ModelSurvey& survey, RepairLog& log, RepairReport& report)
{
  if (last.finished) {
    report.counts_after.islands = last.holes.islands;
    report.class_after = classOf(report.counts_after);
    for (const OpenHole& hole : last.holes.holes)
      if (hole.open != OpenReason::NONE)
        reportOpen(hole, last, log, report);
    return;
  }
  report.counts_after = survey.counts;
  report.class_after = survey.icm_class;
  survey.joined.bridges.clear(); // they led to nothing
  survey.joined.holes = {};
  for (const OpenHole& hole : holesOf(survey, *last.parameters).holes)
    reportOpen(hole, last, log, report);
}

/** The model as it is written, once it is proved to be a manifold. */
RepairedModel
proved(RepairedModel result,
       const ccaa::LoopContext& context,
       RepairLog& log,
       RepairReport& report)
{
  const ccaa::StageClock clock;
  if (!proveManifold(context, result, report)) {
    if (!context.cancelled())
      report.reading.problem = "the result would be no manifold, by a fault of ours";
    return {};
  }
  log.countSeconds("last check", clock.seconds());
  report.new_triangles = result.model.triangles.size() - result.input_triangles;
  return result;
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

/** ICM2 -> closed: each region of holes is subdivided (4.5), filled (4.7), faired and
 * verified. */
Pass
closePass(int pass,
          const RepairParameters& parameters,
          const CloudFrame& frame,
          const ccaa::LoopContext& context,
          ModelSurvey& survey,
          RepairLog& log)
{
  const ccaa::StageClock clock;
  Pass now;
  now.parameters = &parameters;
  now.holes = holesOf(survey, parameters);
  const std::string stage = closingStage(pass);
  now.closed =
      closeHoles(parameters, frame, context, stage.c_str(), now.holes, survey, log);
  now.finished = allIsClosed(now.holes, now.closed);
  log.countSeconds("closing", clock.seconds());
  return now;
}

/** The model with what a pass closed, in order for the next look. */
void
takeClosed(const ccaa::LoopContext& context,
           Pass& pass,
           ModelSurvey& survey,
           std::size_t& input_vertices)
{
  addToModel(context, pass.holes, pass.closed, survey.model, input_vertices);
  survey = putInOrder(std::move(survey), pass.closed.used, context);
  pass.closed.used.assign(survey.model.free_points.size(), false);
}

} // namespace

RepairedModel
repairModel(ModelSurvey survey,
            const pcl::PCLPointCloud2& cloud,
            const RepairParameters& parameters,
            const ccaa::LoopContext& context,
            RepairReport& report)
{
  orientIslands(parameters.survey, context, survey);
  takeDecisions(parameters.survey, survey);
  report.reading = survey.reading;
  if (!survey.reading.problem.empty() || context.cancelled())
    return {};
  RepairedModel result{
      {}, survey.model.positions.size(), survey.model.triangles.size()};
  const CloudFrame frame = frameOf(cloud, survey.reading);
  RepairLog log(survey, report);
  const auto rounds = roundsFor(parameters, diagonalOf(survey.model));
  Pass last;
  for (const RepairParameters& round : rounds) {
    if (log.hasInput())
      takeClosed(context, last, survey, result.input_vertices);
    for (int pass = 0; pass <= MOST_PASSES; ++pass) {
      classifyBoundaries(round.survey, context, survey);
      bridgeIslands(round.survey, context, survey);
      if (context.cancelled())
        return {};
      log.noteLook();
      if (pass == MOST_PASSES)
        break;
      last = closePass(pass, round, frame, context, survey, log);
      if (context.cancelled())
        return {};
      if (last.finished || last.closed.triangles.empty())
        break;
      takeClosed(context, last, survey, result.input_vertices);
    }
    if (!isOpen(last.holes, last.closed))
      break;
  }
  reportEnd(last, survey, log, report);
  addToModel(context, last.holes, last.closed, survey.model, result.input_vertices);
  result.model = std::move(survey.model);
  moveBridges(report.reading.global_shift, report.bridges);
  return proved(std::move(result), context, log, report);
}

} // namespace repair
} // namespace pcl
