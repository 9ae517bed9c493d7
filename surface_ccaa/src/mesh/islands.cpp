// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the edge-connected components of a mesh.
#include "mesh/islands.h"

#include "mesh/disjoint_sets.h"

namespace pcl::ccaa {

Islands
labelIslands(const TriangleAdjacency& adjacency, const LoopContext& context)
{
  const std::size_t count = adjacency.triangleCount();
  DisjointSets sets(count, DisjointSets::Begin::EMPTY);
  forEachBlock(count, context, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      sets.makeSet(t);
  });
  forEachBlock(count, context, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other =
            adjacency.across(static_cast<pcl::index_t>(t), corner);
        if (other >= 0 && static_cast<std::size_t>(other) < t)
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
