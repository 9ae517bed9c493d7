// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: between the indices of a cloud and the ranks of a run.
#include <pcl/surface_ccaa/greedy/usable_points.h>
#include <pcl/surface_ccaa/mesh/block_loop.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace ccaa {

const char*
outOfRange(const GreedyParameters& parameters)
{
  const auto is_angle = [](double angle) { return angle >= 0 && angle <= M_PI / 3; };
  if (parameters.neighbors < 3 || parameters.neighbors > 64)
    return "number of neighbors (3 to 64)";
  if (!is_angle(parameters.minimum_angle))
    return "minimum angle (0 to pi/3 radians)";
  if (!is_angle(parameters.certified_minimum_angle))
    return "certified minimum angle (0 to pi/3 radians)";
  if (!(parameters.length_factor >= 1 && std::isfinite(parameters.length_factor)))
    return "length factor (1 or more)";
  return nullptr;
}

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

RankTable::RankTable(const std::vector<index_t>& order, std::size_t cloud_size)
: ranks_(cloud_size, NeighborRows::NONE)
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
    if (neighbor != rank && neighbor != NeighborRows::NONE)
      found.emplace_back(sqr_distances[i], neighbor);
  }
  std::sort(found.begin(), found.end());
  const std::size_t filled = std::min<std::size_t>(k, found.size());
  for (std::size_t slot = 0; slot < k; ++slot)
    row[slot] = slot < filled ? found[slot].second : NeighborRows::NONE;
}

} // namespace ccaa
} // namespace pcl
