// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the neighbors of many points from any search method.
#include "search/tree_rows.h"

#include <pcl/surface_ccaa/impl/point_blocks.h>

#include <algorithm>
#include <utility>

namespace pcl::ccaa {

RankTable::RankTable(const std::vector<index_t>& order, std::size_t cloud_size)
: ranks_(cloud_size, NeighborTable::NONE)
{
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    ranks_[static_cast<std::size_t>(order[rank])] = static_cast<index_t>(rank);
}

void
RankTable::fillRow(index_t rank,
                   const Indices& near,
                   const std::vector<float>& sqr_distances,
                   unsigned int k,
                   index_t* row) const
{
  // A search method may give more or fewer than it was asked for.
  std::vector<std::pair<float, index_t>> found;
  found.reserve(near.size());
  for (std::size_t i = 0; i < std::min(near.size(), sqr_distances.size()); ++i) {
    const index_t neighbor = ranks_[static_cast<std::size_t>(near[i])];
    if (neighbor != rank && neighbor != NeighborTable::NONE)
      found.emplace_back(sqr_distances[i], neighbor);
  }
  std::sort(found.begin(), found.end());
  const std::size_t filled = std::min<std::size_t>(k, found.size());
  for (std::size_t slot = 0; slot < k; ++slot)
    row[slot] = slot < filled ? found[slot].second : NeighborTable::NONE;
}

bool
searchRows(const TreeSearch& search,
           const IndicesPtr& order,
           std::size_t cloud_size,
           unsigned int k,
           const LoopContext& context,
           std::vector<index_t>& rows)
{
  rows.assign(order->size() * k, NeighborTable::NONE);
  if (order->size() < 3) // some trees do not take an empty selection
    return true;
  search.hold(order);
  const RankTable ranks(*order, cloud_size);
  LoopContext loop = context;
  loop.block_size = 4096; // a search is much work
  return forEachBlock(
      order->size(), loop, [&](std::size_t, std::size_t begin, std::size_t end) {
        Indices near;
        std::vector<float> sqr_distances;
        for (std::size_t rank = begin; rank < end; ++rank) {
          search.nearest((*order)[rank], static_cast<int>(k) + 1, near, sqr_distances);
          ranks.fillRow(
              static_cast<index_t>(rank), near, sqr_distances, k, &rows[rank * k]);
        }
      });
}

} // namespace pcl::ccaa
