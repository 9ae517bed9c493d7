// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins two boundaries all around at once.

#include "pass/ring_joining.h"

#include "boundary/opposed_loops.h"
#include "filling/minimum_weight_filling.h"
#include "listing/junction_rings.h"
#include "pass/ring_filling.h"
#include "pass/surface_takeover.h"
#include "patch/opening.h"
#include "run/stage_clock.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** All around: what bounds joined sheets from outside has not been tried. */
bool
hasFailed(const BoundaryLoop& loop, const Failures& failed)
{
  return std::all_of(loop.vertices.begin(),
                     loop.vertices.end(),
                     [&](pcl::index_t vertex) { return failed.count(vertex) > 0; });
}

/** The ring as one hole, for the report. */
OpenHole
holeOf(const RingPolygon& ring)
{
  OpenHole hole;
  hole.polygon.curve = ring.curve;
  hole.polygon.vertices = ring.vertices;
  return hole;
}

/** Two boundaries that are to be joined. */
struct Ring {
  const BoundaryLoop* first;
  const BoundaryLoop* second;
  RegionMemory::Key key;
};

/** Says that a key is of a ring, not of two holes. */
constexpr std::size_t IS_RING = 1;

RegionMemory::Key
keyOf(const BoundaryLoop& first,
      const BoundaryLoop& second,
      const IncompleteModel& model)
{
  Region both;
  both.holes = {polygonOf(first), polygonOf(second)};
  RegionMemory::Key key = RegionMemory::keyOf(both, model);
  key.numbers.push_back(IS_RING);
  return key;
}

ccaa::Box
boxAround(const Ring& ring)
{
  ccaa::Box box;
  for (const BoundaryLoop* loop : {ring.first, ring.second})
    for (const Position& point : loop->curve.points)
      box.extend(point);
  return ccaa::widened(box, 0.5 * box.diagonal().norm());
}

bool
join(const Ring& ring, const Course& whole, GrowingSurface& surface)
{
  BoundedCourse bounded(whole,
                        ring.first->vertices.size() + ring.second->vertices.size());
  ccaa::RunControl& control = bounded.control;
  const Course& course = bounded.course;
  const ccaa::Box box = boxAround(ring);
  const ModelPart part = surface.part(surface.near(box, &control), &control);
  const std::vector<bool> none_open;
  const RingPlace place{part, none_open, part, box};
  for (const std::vector<RingPolygon>& cut : cutsOf(*ring.first, *ring.second, {})) {
    if (control.cancelled())
      return false;
    const std::optional<Replacement> closed = closeRings(cut, place, course);
    if (!closed)
      continue;
    surface.replace(*closed, course.report.holes.size());
    HoleOutcome outcome;
    outcome.filling = MinimumWeightFilling().name();
    course.log.add(holeOf(cut.front()), outcome);
    return true;
  }
  return false;
}

/** Those that may be closed and have not failed before. */
std::vector<Ring>
ringsFor(const ClosedHoles& pass, const Course& course)
{
  const ModelSurvey& survey = course.survey;
  std::vector<Ring> rings;
  for (const auto& [at_first, at_second] : pass.failed_pairs) {
    const BoundaryLoop* first = loopAt(survey.loops, at_first);
    const BoundaryLoop* second = loopAt(survey.loops, at_second);
    if (first == nullptr || second == nullptr || first == second ||
        !hasFailed(*first, pass.failed) || !hasFailed(*second, pass.failed) ||
        lookTheSameWay(first->curve, second->curve))
      continue;
    Ring ring{first, second, keyOf(*first, *second, survey.model)};
    if (course.memory.find(ring.key) == nullptr)
      rings.push_back(std::move(ring));
  }
  return rings;
}

} // namespace

std::vector<VertexPair>
failedPairs(const ModelSurvey& survey, const Failures& failed)
{
  std::vector<VertexPair> pairs;
  for (const auto& [first, second] : bridgedPairs(survey.joined)) {
    const BoundaryLoop& one = survey.loops[first];
    const BoundaryLoop& other = survey.loops[second];
    if (hasFailed(one, failed) && hasFailed(other, failed))
      pairs.emplace_back(one.vertices.front(), other.vertices.front());
  }
  return pairs;
}

bool
joinRings(const ClosedHoles& pass, const Course& course)
{
  const ccaa::StageClock clock;
  const std::vector<Ring> rings = ringsFor(pass, course);
  if (rings.empty())
    return false;
  const ModelSurvey& survey = course.survey;
  std::size_t edges = 0;
  for (const BoundaryLoop& loop : survey.loops)
    edges += loop.vertices.size();
  BoundedCourse all(course, edges);
  GrowingSurface surface(survey.model, course.report.hole_of, &all.control);
  std::set<const BoundaryLoop*> closed;
  for (const Ring& ring : rings) {
    if (closed.count(ring.first) + closed.count(ring.second) > 0 ||
        all.control.cancelled())
      continue;
    if (join(ring, all.course, surface))
      closed.insert({ring.first, ring.second});
    else
      course.memory.remember(ring.key, {boxAround(ring), {}});
  }
  const bool has_joined = !closed.empty();
  if (has_joined)
    takeOver(std::move(surface), course);
  course.log.countSeconds("rings", clock.seconds());
  return has_joined;
}

} // namespace pcl::repair
