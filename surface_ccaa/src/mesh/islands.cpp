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
  const auto starts = blockStarts(count, context, [&](auto begin, auto end) {
    std::size_t roots = 0;
    for (std::size_t t = begin; t < end; ++t)
      roots += sets.isRoot(t) ? 1 : 0;
    return roots;
  });
  islands.count = starts.back();
  forEachBlock(count, context, [&](auto block, auto begin, auto end) {
    auto next = static_cast<pcl::index_t>(starts[block]);
    for (std::size_t t = begin; t < end; ++t)
      if (sets.isRoot(t)) // the lowest of a set
        islands.of_triangle[t] = next++;
  });
  forEachBlock(count, context, [&](auto, auto begin, auto end) {
    for (std::size_t t = begin; t < end; ++t)
      if (!sets.isRoot(t))
        islands.of_triangle[t] = islands.of_triangle[sets.find(t)];
  });
  return islands;
}

} // namespace pcl::ccaa
