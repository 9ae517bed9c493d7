// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the edge-connected components of a mesh.
#include "mesh/islands.h"

#include "mesh/disjoint_sets.h"

namespace pcl::ccaa {

Islands
labelIslands(const TriangleAdjacency& adjacency,
             const LoopContext& context,
             const std::vector<pcl::index_t>& alone)
{
  const std::size_t count = adjacency.triangleCount();
  std::vector<std::uint8_t> is_alone(alone.empty() ? 0 : count, 0);
  for (const pcl::index_t t : alone)
    is_alone[static_cast<std::size_t>(t)] = 1;
  const auto connects = [&](std::size_t t) {
    return is_alone.empty() || is_alone[t] == 0;
  };
  DisjointSets sets(count, DisjointSets::Begin::EMPTY);
  forEachBlock(count, context, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      sets.makeSet(t);
  });
  forEachBlock(count, context, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int corner = 0; corner < 3 && connects(t); ++corner) {
        const pcl::index_t other =
            adjacency.across(static_cast<pcl::index_t>(t), corner);
        if (other >= 0 && static_cast<std::size_t>(other) < t &&
            connects(static_cast<std::size_t>(other)))
          sets.join(t, static_cast<std::size_t>(other));
      }
  });
  spend(context.control, count);
  Islands islands;
  islands.of_triangle.resize(count);
  for (std::size_t t = 0; t < count; ++t) { // the lowest of a set is its root
    const std::size_t root = sets.find(t);
    islands.of_triangle[t] = root == t ? static_cast<pcl::index_t>(islands.count++)
                                       : islands.of_triangle[root];
  }
  return islands;
}

} // namespace pcl::ccaa
