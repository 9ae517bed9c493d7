// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: loops that belong together but lost their bridges.

#include "listing/junction_rings.h"

#include "boundary/classification.h"
#include "boundary/opposed_loops.h"
#include "listing/ring_polygons.h"
#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

/** D of a loop in its length from which it is no rim around its island. */
constexpr double LEAST_D = -0.6;

/** Whether a loop may be one side of a ring. */
bool
mayBeRing(const ModelSurvey& survey, std::size_t loop)
{
  const std::size_t input_loop =
      survey.wishes.inputLoop(survey.model, survey.loops[loop]);
  const Island& island = survey.model.islands[survey.loops[loop].island];
  return survey.classes[loop].boundary_class != BoundaryClass::OUTER_BORDER &&
         island.triangles >= CRUMB_TRIANGLES && !island.one_sided &&
         survey.classes[loop].evidence.integral.relative() > LEAST_D &&
         survey.wishes.wishFor(input_loop) != LoopWish::LEAVE_OPEN;
}

} // namespace

std::vector<LoopPair>
bridgedPairs(const SurveyedBridges& joined)
{
  auto partners = partnersOver(joined, true);
  std::vector<const Junction*> junctions;
  for (const Junction& junction : joined.junctions)
    junctions.push_back(&junction);
  std::stable_sort(
      junctions.begin(), junctions.end(), [](const Junction* a, const Junction* b) {
        return a->evidence.logOdds() > b->evidence.logOdds();
      });
  std::vector<LoopPair> pairs;
  for (const Junction* junction : junctions) {
    const LoopPair pair{joined.loops[junction->curves[0]],
                        joined.loops[junction->curves[1]]};
    if (partners[pair.first].count(pair.second) > 0)
      pairs.push_back(pair);
  }
  return pairs;
}

std::vector<OpenHole>
ringsOverJunctions(const ModelSurvey& survey)
{
  if (survey.joined.holes.removed_bridges.empty() || !isSeenFromAllSides(survey.facing))
    return {};
  auto partners = partnersOver(survey.joined, false);
  ccaa::DisjointSets groups(survey.model.islands.size());
  for (const auto& [loop, others] : partners)
    for (const std::size_t other : others)
      groups.join(survey.loops[loop].island, survey.loops[other].island);
  std::vector<OpenHole> rings;
  for (const auto& [one, other] : bridgedPairs(survey.joined)) {
    const BoundaryLoop& first = survey.loops[one];
    const BoundaryLoop& second = survey.loops[other];
    if (partners.count(one) > 0 || partners.count(other) > 0 ||
        groups.find(first.island) == groups.find(second.island) ||
        lookTheSameWay(first.curve, second.curve) || !mayBeRing(survey, one) ||
        !mayBeRing(survey, other))
      continue;
    RingPolygon ring = std::move(cutsOf(first, second, {}).front().front());
    OpenHole hole;
    hole.polygon = {std::move(ring.curve), std::move(ring.vertices), ring.second_loop};
    hole.loop = one;
    hole.other_loop = other;
    rings.push_back(std::move(hole));
    partners[one].insert(other);
    partners[other].insert(one);
    groups.join(first.island, second.island);
  }
  return rings;
}

} // namespace pcl::repair
