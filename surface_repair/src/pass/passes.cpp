// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: classify, bridge and close, and look again.

#include "pass/passes.h"

#include "boundary/classification.h"
#include "listing/loop_reasons.h"
#include "pass/ring_joining.h"
#include "region/filling_choice.h"
#include "region/region_parts.h"
#include "run/stage_clock.h"
#include "survey/survey_stages.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace pcl::repair {

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

/** ICM2 -> closed: each region of holes is subdivided (4.5), filled (4.7), faired and
 * verified. */
Pass
closePass(int pass,
          bool over_samples,
          const RepairParameters& parameters,
          const Course& course)
{
  const ccaa::StageClock clock;
  Pass now;
  now.parameters = &parameters;
  now.holes = holesOf(course.survey, parameters, over_samples);
  const std::string stage = closingStage(pass);
  now.closed = closeHoles(parameters,
                          course.frame,
                          course.context,
                          stage.c_str(),
                          now.holes,
                          course.survey,
                          course.memory,
                          course.log);
  now.closed.failed_pairs = failedPairs(course.survey, now.closed.failed);
  now.finished = allIsClosed(now.holes, now.closed);
  course.log.countSeconds("closing", clock.seconds());
  return now;
}

/** Classify and bridge, unless that was done and nothing has changed since. */
void
lookAs(const RepairParameters& round, const Course& course)
{
  const ccaa::LoopContext& context = course.context;
  ModelSurvey& survey = course.survey;
  if (survey.bridged_by == &round.survey)
    return;
  if (survey.classes.size() != survey.loops.size())
    classifyBoundaries(round.survey, context, survey);
  bridgeIslands(round.survey, context, survey);
  if (context.cancelled())
    return;
  survey.bridged_by = &round.survey;
  course.log.noteLook();
}

/** Whether another look may find more. In a body what is left is told by what was
 * closed, too. In what is seen from one side, of 11 passes none has closed anything
 * after one that had closed nothing but whole boundaries by themselves. */
bool
mayFindMore(const ClosedHoles& closed, const ModelSurvey& survey)
{
  return closed.has_changed_others ||
         (!closed.triangles.empty() && isSeenFromAllSides(survey.facing));
}

/** Classify, bridge and close, and again as long as that may find more. */
Pass
closeRound(const RepairParameters& round, bool over_samples, const Course& course)
{
  const ccaa::LoopContext& context = course.context;
  Pass last;
  for (int pass = 0; pass < MOST_PASSES; ++pass) {
    lookAs(round, course);
    if (context.cancelled())
      break;
    last = closePass(pass, over_samples, round, course);
    if (context.cancelled() || last.finished)
      break;
    const bool may_find_more = mayFindMore(last.closed, course.survey);
    takeClosed(last, course);
    if (context.cancelled() || !(joinRings(last.closed, course) || may_find_more))
      break;
  }
  return last;
}

} // namespace

BoundedCourse::BoundedCourse(const Course& whole,
                             ccaa::RunControl* run,
                             std::uint64_t most_work)
: control(run, most_work)
, course{whole.parameters,
         whole.rounds,
         whole.frame,
         context,
         whole.survey,
         whole.memory,
         whole.log,
         whole.report,
         whole.input_vertices}
{}

std::vector<RepairParameters>
roundsFor(const RepairParameters& wanted, double diagonal)
{
  RepairParameters first = wanted;
  first.survey.simple_edges = simpleEdges(wanted.filling);
  first.survey.trace_in_holes = false;
  first.survey.trace_between_islands = wanted.join_islands;
  for (Extent* limit : {&first.filling.greatest_length, &first.survey.greatest_bridge})
    *limit = Extent(limit->length(diagonal));
  if (!wanted.closesAll())
    return {first};
  first.filling.close = CloseChoice::HOLES;
  RepairParameters second = first;
  second.filling.close = CloseChoice::ALL;
  second.survey.trace_between_islands = false;
  return {first, second};
}

double
longestJoin(const RepairParameters& parameters)
{
  if (!parameters.join_islands)
    return 0.0;
  const Extent& limit = parameters.survey.greatest_bridge;
  return limit.limits() ? limit.value : std::numeric_limits<double>::infinity();
}

HoleList
holesOf(const ModelSurvey& survey,
        const RepairParameters& parameters,
        bool over_samples)
{
  HoleList list = listHoles(
      survey, parameters.filling, over_samples ? longestJoin(parameters) : 0.0);
  if (!parameters.join_islands && survey.model.islands.size() > 1)
    for (OpenHole& hole : list.holes)
      if (couldBeJoined(hole.open))
        hole.open = OpenReason::NOT_WANTED;
  return list;
}

void
look(const Pass& last, const Course& course)
{
  if (!course.context.cancelled())
    lookAs(*last.parameters, course);
}

void
takeClosed(Pass& pass, const Course& course)
{
  if (pass.closed.triangles.empty())
    return;
  ModelSurvey& survey = course.survey;
  addToModel(
      course.context, pass.holes, pass.closed, survey.model, course.input_vertices);
  survey = putInOrder(std::move(survey), pass.closed.used, course.context);
  pass.closed.used.assign(survey.model.free_points.size(), false);
}

Pass
closeRounds(const Course& course, bool over_samples)
{
  Pass last;
  for (const RepairParameters& round : course.rounds) {
    takeClosed(last, course);
    if (course.context.cancelled())
      break;
    last = closeRound(round, over_samples, course);
    if (course.context.cancelled() || !isOpen(last.holes, last.closed))
      break;
  }
  return last;
}

} // namespace pcl::repair
