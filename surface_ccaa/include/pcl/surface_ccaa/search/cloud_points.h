// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a PCL cloud, and indices that are none of
// them.
#pragma once

#include <pcl/surface_ccaa/search/curve_order.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cstddef>

namespace pcl {
namespace ccaa {

/** \brief The coordinates of a cloud, which must outlive the view. */
template <typename PointT>
PointArray
pointArrayOf(const PointCloud<PointT>& cloud)
{
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points are rows of floats");
  if (cloud.empty())
    return {};
  return {&cloud.front().x, sizeof(PointT) / sizeof(float), cloud.size()};
}

/** \brief The first index that is none of a cloud with so many points; the end when all
 * are. */
Indices::const_iterator
findIndexOutside(const Indices& indices, std::size_t point_count);

} // namespace ccaa
} // namespace pcl
