// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a cloud says about the outer side of its surface.
#pragma once

#include <pcl/surface_ccaa/mesh/side_hints.h>
#include <pcl/surface_ccaa/search/curve_order.h>
#include <pcl/point_cloud.h>
#include <pcl/point_struct_traits.h>
#include <pcl/point_types.h>
#include <pcl/type_traits.h>

namespace pcl {
namespace ccaa {

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

} // namespace ccaa
} // namespace pcl
