// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: triangles all around between two loops.

#include "filling/ring_stitching.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl::repair {

Filling
stitchRing(const BoundaryCurve& ring, std::size_t second)
{
  // Steps along the first loop, and back along the second one: each is a triangle.
  const std::size_t firsts = second;
  const std::size_t seconds = ring.size() - second;
  const auto place = [&](std::size_t j) { return ring.size() - 1 - j; };
  const auto rung = [&](std::size_t i, std::size_t j) {
    return (ring.points[i] - ring.points[place(j)]).norm();
  };
  std::vector<double> least(firsts * seconds, std::numeric_limits<double>::infinity());
  std::vector<bool> is_step_of_first(least.size(), false);
  least.front() = 0.0;
  for (std::size_t i = 0; i < firsts; ++i)
    for (std::size_t j = 0; j < seconds; ++j) {
      double& best = least[i * seconds + j];
      if (i > 0) {
        best = least[(i - 1) * seconds + j] + rung(i, j);
        is_step_of_first[i * seconds + j] = true;
      }
      if (j > 0 && least[i * seconds + j - 1] + rung(i, j) < best) {
        best = least[i * seconds + j - 1] + rung(i, j);
        is_step_of_first[i * seconds + j] = false;
      }
    }
  Filling filling;
  for (std::size_t i = firsts - 1, j = seconds - 1; i + j > 0;) {
    const auto own = static_cast<pcl::index_t>(i);
    const auto other = static_cast<pcl::index_t>(place(j));
    if (is_step_of_first[i * seconds + j]) {
      filling.triangles.push_back({own, own - 1, other});
      --i;
    }
    else {
      filling.triangles.push_back({other + 1, other, own});
      --j;
    }
  }
  std::reverse(filling.triangles.begin(), filling.triangles.end());
  return filling;
}

} // namespace pcl::repair
