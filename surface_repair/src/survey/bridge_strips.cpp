// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bridges that lead beside each other.

#include "survey/bridge_strips.h"

#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

CurvePair
curvesOf(const Bridge& bridge)
{
  const auto [low, high] = std::minmax(bridge.begin.curve, bridge.end.curve);
  return {low, high};
}

} // namespace

Strips
stripsOf(const SurveyedBridges& joined)
{
  ccaa::DisjointSets sets(joined.bridges.size());
  std::vector<std::size_t> between;
  for (const HoleContour& contour : joined.holes.contours)
    if (const auto& steps = contour.steps;
        steps.size() == 2 && steps[0].bridge != NONE && steps[1].bridge != NONE &&
        curvesOf(joined.bridges[steps[0].bridge]) ==
            curvesOf(joined.bridges[steps[1].bridge])) {
      sets.join(steps[0].bridge, steps[1].bridge);
      between.push_back(steps[0].bridge);
    }
  std::map<std::size_t, Strip> strip_of;
  for (std::size_t b = 0; b < joined.bridges.size(); ++b)
    strip_of[sets.find(b)].bridges.push_back(b);
  for (const std::size_t b : between)
    ++strip_of[sets.find(b)].contours;
  Strips strips;
  for (auto& [root, strip] : strip_of)
    strips[curvesOf(joined.bridges[root])].push_back(std::move(strip));
  for (auto& [curves, some] : strips)
    std::stable_sort(some.begin(), some.end(), [](const Strip& a, const Strip& b) {
      return a.bridges.size() < b.bridges.size();
    });
  return strips;
}

} // namespace pcl::repair
