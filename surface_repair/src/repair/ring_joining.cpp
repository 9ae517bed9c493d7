// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins two boundaries all around at once.

#include "repair/ring_joining.h"

#include "boundary/opposed_loops.h"
#include "filling/minimum_weight_filling.h"
#include "repair/junction_rings.h"
#include "repair/region_parts.h"
#include "repair/ring_filling.h"

#include <algorithm>
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

bool
join(const BoundaryLoop& first,
     const BoundaryLoop& second,
     const Course& whole,
     GrowingSurface& surface)
{
  ccaa::RunControl control(whole.context.control,
                           workFor(first.vertices.size() + second.vertices.size()));
  const ccaa::LoopContext context{1, &control};
  const Course course = within(whole, context);
  ccaa::Box box;
  for (const BoundaryLoop* loop : {&first, &second})
    for (const Position& point : loop->curve.points)
      box.extend(point);
  box = ccaa::widened(box, 0.5 * box.diagonal().norm());
  const ModelPart part = surface.part(surface.near(box, &control), &control);
  const std::vector<bool> none_open;
  const RingPlace place{part, none_open, part, box};
  for (const std::vector<RingPolygon>& rings : cutsOf(first, second, {})) {
    if (control.cancelled())
      return false;
    if (!closeRings(rings, place, course.report.holes.size(), course, surface))
      continue;
    HoleOutcome outcome;
    outcome.filling = MinimumWeightFilling().name();
    course.log.add(holeOf(rings.front()), outcome);
    return true;
  }
  return false;
}

} // namespace

bool
joinRings(const Failures& failed, const Course& course)
{
  ModelSurvey& survey = course.survey;
  std::size_t edges = 0;
  for (const BoundaryLoop& loop : survey.loops)
    edges += loop.vertices.size();
  ccaa::RunControl control(course.context.control, workFor(edges)); // of all rings
  const ccaa::LoopContext context{1, &control};
  GrowingSurface surface(survey.model, course.report.hole_of, &control);
  std::set<std::size_t> closed;
  for (const auto& [first, second] : bridgedPairs(survey.joined)) {
    const BoundaryLoop& one = survey.loops[first];
    const BoundaryLoop& other = survey.loops[second];
    if (closed.count(first) + closed.count(second) == 0 &&
        !lookTheSameWay(one.curve, other.curve) && hasFailed(one, failed) &&
        hasFailed(other, failed) && !control.cancelled() &&
        join(one, other, within(course, context), surface))
      closed.insert({first, second});
  }
  const bool has_joined = !closed.empty();
  if (has_joined)
    takeOver(std::move(surface), course);
  return has_joined;
}

} // namespace pcl::repair
