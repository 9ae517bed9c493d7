// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins two boundaries all around at once.

#include "pass/ring_joining.h"

#include "boundary/opposed_loops.h"
#include "filling/minimum_weight_filling.h"
#include "listing/junction_rings.h"
#include "pass/ring_filling.h"
#include "pass/surface_takeover.h"
#include "pass/surface_tries.h"
#include "patch/opening.h"
#include "region/region_parts.h"
#include "run/stage_clock.h"

#include <algorithm>
#include <cstdint>
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

/** What becomes of a ring. */
struct JoinedRing {
  std::optional<Replacement> patch; /**< if it could be closed */
  OpenHole hole;
  ccaa::Box seen;
  std::uint64_t work = 0;
};

JoinedRing
join(const Ring& ring,
     const Course& whole,
     ccaa::RunControl* run,
     const GrowingSurface& surface)
{
  BoundedCourse bounded(
      whole, run, workFor(ring.first->vertices.size() + ring.second->vertices.size()));
  ccaa::RunControl& control = bounded.control;
  JoinedRing joined;
  joined.seen = boxAround(ring);
  const ModelPart part = surface.part(surface.near(joined.seen, &control), &control);
  const std::vector<bool> none_open;
  const RingPlace place{part, none_open, part, joined.seen, &control};
  const auto cuts = cutsOf(*ring.first, *ring.second, {});
  joined.patch = closeRing(cuts, place, bounded.course);
  joined.hole = holeOf(cuts.front().front());
  joined.work = control.work();
  return joined;
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
  GrowingSurface surface(survey.model, course.report.hole_of, course.context.control);
  std::set<const BoundaryLoop*> closed;
  std::uint64_t work_left = workFor(edges);
  const auto mayJoin = [&](const Ring& ring) {
    return work_left > 0 && closed.count(ring.first) + closed.count(ring.second) == 0;
  };
  const auto tryOut = [&](std::size_t i, const ccaa::LoopContext& context) {
    return mayJoin(rings[i]) ? join(rings[i], course, context.control, surface)
                             : JoinedRing();
  };
  const auto make = [&](std::size_t i, const JoinedRing& joined) -> ccaa::Box {
    const Ring& ring = rings[i];
    if (!mayJoin(ring))
      return {};
    work_left -= std::min(work_left, joined.work);
    if (!joined.patch) {
      course.memory.remember(ring.key, {joined.seen, {}});
      return {};
    }
    closed.insert({ring.first, ring.second});
    HoleOutcome outcome;
    outcome.filling = MinimumWeightFilling().name();
    return surface.replace(*joined.patch, course.log.add(joined.hole, outcome));
  };
  makeInTurn(rings.size(), course.context, tryOut, make);
  const bool has_joined = !closed.empty();
  if (has_joined)
    takeOver(std::move(surface), course);
  course.log.countSeconds("rings", clock.seconds());
  return has_joined;
}

} // namespace pcl::repair
