// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stumps of one limb, by the samples between them.

#include "listing/sampled_rings.h"

#include "boundary/classification.h"
#include "listing/ring_polygons.h"
#include "listing/sample_shares.h"

#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Whether a loop may be one side of a ring. */
bool
isCandidate(const ModelSurvey& survey, std::size_t loop)
{
  const std::size_t input_loop =
      survey.wishes.inputLoop(survey.model, survey.loops[loop]);
  return survey.classes[loop].boundary_class != BoundaryClass::OUTER_BORDER &&
         !survey.model.islands[survey.loops[loop].island].one_sided &&
         survey.wishes.wishFor(input_loop) != LoopWish::LEAVE_OPEN;
}

bool
mayBeJoined(const ModelSurvey& survey,
            const BoundaryLoop& first,
            const BoundaryLoop& second)
{
  return first.island != second.island &&
         (!survey.wishes.keepApart() ||
          survey.wishes.mayJoin(survey.model, first, second));
}

double
gapOf(const RingPolygon& ring)
{
  return (ring.curve.points[ring.second_loop] - ring.curve.points[ring.second_loop - 1])
      .norm();
}

/** Whether all bridges of a loop lead to another one. */
bool
leadTo(std::size_t loop, const std::set<std::size_t>& partners)
{
  return partners.count(loop) == partners.size();
}

/** Over a gap that is longer than a limb there is thick bridges do not do as well. */
bool
isLong(const RingPolygon& ring)
{
  ccaa::Box box;
  for (std::size_t k = ring.second_loop; k < ring.curve.size(); ++k)
    box.extend(ring.curve.points[k]);
  return gapOf(ring) > box.diagonal().norm();
}

} // namespace

std::vector<OpenHole>
ringsOverSamples(const ModelSurvey& survey, double longest)
{
  if (!survey.guides || !survey.guides->free_points || !(longest > 0.0) ||
      survey.model.islands.size() < 2 || !isSeenFromAllSides(survey.facing))
    return {};
  auto partners = partnersOver(survey.joined, false);
  std::vector<std::size_t> loops;
  std::vector<Region> regions;
  for (std::size_t loop = 0; loop < survey.loops.size(); ++loop)
    if (isCandidate(survey, loop)) {
      loops.push_back(loop);
      regions.emplace_back();
      regions.back().holes.push_back(polygonOf(survey.loops[loop]));
    }
  std::vector<OpenHole> rings;
  for (const auto& [one, other] :
       regionsThatSamplesLink(survey.model, *survey.guides->free_points, regions)) {
    const BoundaryLoop& first = survey.loops[loops[one]];
    const BoundaryLoop& second = survey.loops[loops[other]];
    if (!mayBeJoined(survey, first, second) ||
        !leadTo(loops[other], partners[loops[one]]) ||
        !leadTo(loops[one], partners[loops[other]]))
      continue;
    RingPolygon ring = std::move(cutsOf(first, second, {}).front().front());
    if (gapOf(ring) > longest || !(isLong(ring) || partners[loops[one]].empty()))
      continue;
    OpenHole hole;
    hole.polygon = {std::move(ring.curve), std::move(ring.vertices), ring.second_loop};
    hole.loop = loops[one];
    hole.other_loop = loops[other];
    rings.push_back(std::move(hole));
  }
  return rings;
}

} // namespace pcl::repair
