// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: takes back relaxation where it runs into something.

#include "patch/relaxation_rollback.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** Edges over which a vertex goes back less and less: the rest of a patch stays fair.
 */
constexpr std::size_t FADING = 4;

/** Edges between each vertex and the nearest of some triangles, at most `farthest`. */
std::vector<std::size_t>
edgesFrom(const std::vector<std::size_t>& triangles,
          std::size_t farthest,
          const Patch& patch)
{
  std::vector<std::size_t> edges(patch.positions.size(), farthest);
  for (const std::size_t triangle : triangles)
    for (const pcl::index_t corner : patch.triangles[triangle])
      edges[static_cast<std::size_t>(corner)] = 0;
  for (std::size_t ring = 0; ring + 1 < farthest; ++ring)
    for (const Triangle& triangle : patch.triangles) {
      const bool touches =
          std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
            return edges[static_cast<std::size_t>(corner)] == ring;
          });
      if (touches)
        for (const pcl::index_t corner : triangle) {
          std::size_t& own = edges[static_cast<std::size_t>(corner)];
          own = std::min(own, ring + 1);
        }
    }
  return edges;
}

} // namespace

void
rollBackRelaxation(const Positions& before,
                   const std::vector<std::size_t>& triangles,
                   std::size_t rings,
                   Patch& patch)
{
  const std::size_t farthest = rings + FADING;
  const std::vector<std::size_t> edges = edgesFrom(triangles, farthest, patch);
  for (std::size_t v = 0; v < patch.positions.size(); ++v) {
    const std::size_t beyond = edges[v] > rings ? edges[v] - rings : 0;
    const double back = 1.0 - static_cast<double>(beyond) / static_cast<double>(FADING);
    if (!patch.isHeld(v))
      patch.positions[v] += back * (before[v] - patch.positions[v]);
  }
}

} // namespace pcl::repair
