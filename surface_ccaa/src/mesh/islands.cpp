// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the edge-connected components of a mesh.
#include "mesh/islands.h"

namespace pcl {
namespace ccaa {

Islands
labelIslands(const TriangleAdjacency& adjacency)
{
  constexpr pcl::index_t UNSEEN = -1;
  Islands islands;
  islands.of_triangle.assign(adjacency.triangleCount(), UNSEEN);
  std::vector<pcl::index_t> stack;
  for (std::size_t seed = 0; seed < islands.of_triangle.size(); ++seed) {
    if (islands.of_triangle[seed] != UNSEEN)
      continue;
    const auto island = static_cast<pcl::index_t>(islands.count++);
    islands.of_triangle[seed] = island;
    stack.push_back(static_cast<pcl::index_t>(seed));
    while (!stack.empty()) {
      const pcl::index_t t = stack.back();
      stack.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other = adjacency.across(t, corner);
        if (other < 0 || islands.of_triangle[static_cast<std::size_t>(other)] != UNSEEN)
          continue;
        islands.of_triangle[static_cast<std::size_t>(other)] = island;
        stack.push_back(other);
      }
    }
  }
  return islands;
}

} // namespace ccaa
} // namespace pcl
