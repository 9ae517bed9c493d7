// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair, stage by stage.

#include "repair/repair_method.h"

#include "crumb/crumbs.h"
#include "listing/loop_reasons.h"
#include "listing/sampled_rings.h"
#include "pass/hole_reopening.h"
#include "pass/passes.h"
#include "run/stage_clock.h"
#include "survey/survey_stages.h"
#include "verification/doubts.h"
#include "verification/last_check.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Discs of so many times the triangles of a crumb are laid into patches, too, where
 * bridges have not joined them. */
constexpr std::size_t LAID_CRUMBS = 10;

CloudFrame
frameOf(const pcl::PCLPointCloud2& cloud, const ReadingReport& reading)
{
  const bool has_floats =
      std::any_of(cloud.fields.begin(), cloud.fields.end(), [](const auto& field) {
        return field.name == "x" && field.datatype == pcl::PCLPointField::FLOAT32;
      });
  return {has_floats, reading.global_shift};
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
reportEnd(const Pass& last, const Course& course)
{
  RepairReport& report = course.report;
  if (last.finished) {
    report.counts_after.islands = last.holes.islands;
    report.class_after = classOf(report.counts_after);
    for (const OpenHole& hole : last.holes.holes)
      if (hole.open != OpenReason::NONE)
        reportOpen(hole, last, course.log, report);
    return;
  }
  look(last, course);
  ModelSurvey& survey = course.survey;
  report.counts_after = survey.counts;
  report.class_after = survey.icm_class;
  survey.joined.bridges.clear(); // they led to nothing
  survey.joined.holes = {};
  for (const OpenHole& hole : holesOf(survey, *last.parameters).holes)
    reportOpen(hole, last, course.log, report);
}

/** The model as it is written, once it is proved to be a manifold. */
RepairedModel
proved(RepairedModel result,
       const RepairParameters& parameters,
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
  ccaa::spend(context.control, result.model.triangles.size());
  report.doubts = doubtsAbout(result, report, parameters);
  ccaa::spend(context.control, result.model.triangles.size());
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

/** Some island is still none of a larger one. */
bool
hasUnjoined(const Pass& last)
{
  const std::vector<OpenHole>& holes = last.holes.holes;
  return std::any_of(holes.begin(), holes.end(), [](const OpenHole& hole) {
    return couldBeJoined(hole.open);
  });
}

/** Some hole stayed open because a patch would run through something. */
bool
hasObstructed(const ClosedHoles& closed)
{
  return std::any_of(
      closed.failed.begin(), closed.failed.end(), [](const auto& failure) {
        return failure.second.open == OpenReason::INTERSECTION;
      });
}

/** Islands of fewer triangles are crumbs. What users decide is about all islands. */
std::size_t
crumbsOf(const RepairParameters& parameters)
{
  const bool decided = parameters.survey.decisions != nullptr;
  return parameters.join_islands && !decided ? parameters.crumb_triangles : 0;
}

/** The last pass after crumbs are laid. */
Pass
afterCrumbs(const Crumbs& crumbs,
            std::size_t crumb_triangles,
            Pass last,
            const Course& course)
{
  const ccaa::StageClock clock;
  if (course.context.cancelled())
    return last;
  takeClosed(last, course);
  if (course.context.cancelled())
    return last;
  if (!crumbs.empty())
    putCrumbsBack(crumbs, course);
  if (course.context.cancelled())
    return last;
  layCrumbs(LAID_CRUMBS * crumb_triangles, course);
  course.log.countSeconds("crumbs", clock.seconds());
  return closeRounds(course);
}

/** The last pass after stumps that are still open are joined over samples. */
Pass
afterSamples(Pass last, const Course& course)
{
  const double longest = longestJoin(course.rounds.front());
  look(last, course);
  if (course.context.cancelled() || ringsOverSamples(course.survey, longest).empty())
    return last;
  takeClosed(last, course);
  return closeRounds(course, true);
}

/** The last pass after holes are opened wider. */
Pass
afterReopening(Pass last, const Course& course)
{
  const ccaa::StageClock clock;
  if (course.context.cancelled())
    return last;
  takeClosed(last, course);
  if (course.context.cancelled())
    return last;
  reopenHoles(last.closed.failed, course);
  course.log.countSeconds("reopening", clock.seconds());
  return closeRounds(course);
}

/** Vertices at boundaries that could not be closed, or not be joined. */
std::set<pcl::index_t>
unjoinedVertices(const Pass& last)
{
  std::set<pcl::index_t> vertices;
  for (const auto& [vertex, failure] : last.closed.failed)
    vertices.insert(vertex);
  for (const OpenHole& hole : last.holes.holes)
    if (couldBeJoined(hole.open) && hole.loop != NONE)
      vertices.insert(hole.polygon.vertices.begin(), hole.polygon.vertices.end());
  return vertices;
}

/** The last pass after small islands that could not be joined have waited like crumbs.
 */
Pass
afterWaiting(std::size_t crumb_triangles, Pass last, const Course& course)
{
  if (course.context.cancelled() || !last.closed.triangles.empty())
    return last;
  const Crumbs waiting =
      setUnjoinedAside(LAID_CRUMBS * crumb_triangles, unjoinedVertices(last), course);
  last = closeRounds(course);
  if (waiting.empty())
    return last;
  return afterCrumbs(waiting, crumb_triangles, std::move(last), course);
}

/** Passes, and then what these could not close, in other ways. */
Pass
closeAll(const Crumbs& crumbs, std::size_t crumb_triangles, const Course& course)
{
  Pass last = closeRounds(course);
  if (!crumbs.empty() || (crumb_triangles > 0 && hasUnjoined(last)))
    last = afterCrumbs(crumbs, crumb_triangles, std::move(last), course);
  if (!last.finished)
    last = afterSamples(std::move(last), course);
  if (hasObstructed(last.closed))
    last = afterReopening(std::move(last), course);
  if (crumb_triangles > 0 && course.survey.model.islands.size() > 1 && !last.finished)
    last = afterWaiting(crumb_triangles, std::move(last), course);
  return last;
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
  const auto rounds = roundsFor(parameters, diagonalOf(survey.model));
  classifyBoundaries(rounds.front().survey, context, survey);
  if (context.cancelled())
    return {};
  RepairLog log(survey, report);
  log.noteInput();
  const std::size_t crumb_triangles = crumbsOf(parameters);
  const Crumbs crumbs = setCrumbsAside(crumb_triangles, context, survey);
  log.leaveOut(crumbs.triangles.size());
  RepairedModel result{{}, survey.model.positions.size(), report.input_triangles};
  const CloudFrame frame = frameOf(cloud, survey.reading);
  RegionMemory memory;
  const Course course{parameters,
                      rounds,
                      frame,
                      context,
                      survey,
                      memory,
                      log,
                      report,
                      result.input_vertices};
  Pass last = closeAll(crumbs, crumb_triangles, course);
  if (context.cancelled())
    return {};
  reportEnd(last, course);
  if (context.cancelled())
    return {};
  addToModel(context, last.holes, last.closed, survey.model, result.input_vertices);
  result.model = std::move(survey.model);
  moveBridges(report.reading.global_shift, report.bridges);
  return proved(std::move(result), parameters, context, log, report);
}

} // namespace pcl::repair
