// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a PCL cloud and its search method, as compiled code sees
// them.
#pragma once

#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/impl/cloud_runs.h>
#include <pcl/point_cloud.h>
#include <pcl/point_struct_traits.h>
#include <pcl/point_types.h>
#include <pcl/type_traits.h>

#include <memory>
#include <vector>

namespace pcl::ccaa {

template <typename PointT>
PointArray
arrayFrom(const float& first, const PointCloud<PointT>& cloud)
{
  return {&first, sizeof(PointT) / sizeof(float), cloud.size()};
}

/** \brief The normals of a cloud, which must outlive the view; empty where the point
 * type has none. */
template <typename PointT>
PointArray
normalArrayOf(const PointCloud<PointT>& cloud)
{
  if constexpr (traits::has_normal<PointT>::value)
    if (!cloud.empty())
      return arrayFrom(cloud.front().normal_x, cloud);
  return {};
}

/** \brief The sensor positions of its points, fields vp_x, vp_y and vp_z. */
template <typename PointT>
PointArray
viewpointArrayOf(const PointCloud<PointT>& cloud)
{
  if constexpr (traits::has_field<PointT, fields::vp_x>::value)
    if (!cloud.empty())
      return arrayFrom(cloud.front().vp_x, cloud);
  return {};
}

/** \brief What is told, and the sensor's place of the cloud where it is set. */
template <typename PointT>
SideHints
sidesOf(const PointCloud<PointT>& cloud, SideHints told)
{
  const Eigen::Vector3f origin = cloud.sensor_origin_.template head<3>();
  if (!told.viewpoint && origin.allFinite() && !origin.isZero(0.0f))
    told.viewpoint = origin.cast<double>();
  return told;
}

/** \brief A search method and the cloud that it searches. A search::BlockSearch takes
 * points in with as many threads as the run has. */
template <typename PointT>
TreeSearch
treeSearchOf(const typename search::Search<PointT>::Ptr& tree,
             const typename PointCloud<PointT>::ConstPtr& cloud,
             unsigned int threads)
{
  TreeSearch search;
  search.nearest =
      [tree,
       cloud](index_t point, int k, Indices& near, std::vector<float>& sqr_distances) {
        tree->nearestKSearch(
            (*cloud)[static_cast<std::size_t>(point)], k, near, sqr_distances);
      };
  const auto blocks = std::dynamic_pointer_cast<search::BlockSearch<PointT>>(tree);
  if (!blocks) {
    search.hold = [tree, cloud](const IndicesPtr& chosen) {
      tree->setInputCloud(cloud, chosen);
    };
    return search;
  }
  search.blocks = &blocks->getPointBlocks();
  search.hold = [blocks, cloud, threads](const IndicesPtr& chosen) {
    const unsigned int own_threads = blocks->getNumberOfThreads();
    blocks->setNumberOfThreads(threads);
    blocks->setInputCloud(cloud, chosen);
    blocks->setNumberOfThreads(own_threads);
  };
  return search;
}

} // namespace pcl::ccaa
