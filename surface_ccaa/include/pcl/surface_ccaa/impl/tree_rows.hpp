// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the neighbors of many points from any search method.
#pragma once

#include <pcl/search/search.h>
#include <pcl/surface_ccaa/greedy/usable_points.h>
#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief The nearest of some points among themselves, asked for point by point; fewer
 * than three points get none.
 * \param[in] tree gets these points as its input
 * \param[in] order rank -> index in the cloud
 * \param[in] k length of a row
 * \param[out] rows one of k ranks for each rank, see RankTable::fillRow()
 * \return false when cancelled */
template <typename PointT>
bool
searchRows(search::Search<PointT>& tree,
           const typename PointCloud<PointT>::ConstPtr& cloud,
           const IndicesConstPtr& order,
           unsigned int k,
           const LoopContext& context,
           std::vector<index_t>& rows)
{
  rows.assign(order->size() * k, NeighborRows::NONE);
  if (order->size() < 3) // some trees do not take an empty selection
    return true;
  tree.setInputCloud(cloud, order);
  const RankTable ranks(*order, cloud->size());
  LoopContext loop = context;
  loop.block_size = 4096; // a search is much work
  return forEachBlock(
      order->size(), loop, [&](std::size_t, std::size_t begin, std::size_t end) {
        Indices near;
        std::vector<float> sqr_distances;
        for (std::size_t rank = begin; rank < end; ++rank) {
          const PointT& point = (*cloud)[static_cast<std::size_t>((*order)[rank])];
          tree.nearestKSearch(point, static_cast<int>(k) + 1, near, sqr_distances);
          ranks.fillRow(
              static_cast<index_t>(rank), near, sqr_distances, k, &rows[rank * k]);
        }
      });
}

} // namespace ccaa
} // namespace pcl
