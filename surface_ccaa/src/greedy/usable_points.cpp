// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a cloud by the ranks of a run.
#include "greedy/usable_points.h"

#include "mesh/block_loop.h"

namespace pcl::ccaa {

RankedPoints
rankPoints(const PointArray& points, const std::vector<index_t>& order, int threads)
{
  RankedPoints ranked;
  ranked.point_indices = order;
  ranked.coordinates.resize(order.size());
  forEachBlock(order.size(),
               LoopContext{threads},
               [&](std::size_t, std::size_t first, std::size_t last) {
                 for (std::size_t rank = first; rank < last; ++rank) {
                   const float* xyz = points[order[rank]];
                   ranked.coordinates[rank] = {xyz[0], xyz[1], xyz[2]};
                 }
               });
  return ranked;
}

} // namespace pcl::ccaa
