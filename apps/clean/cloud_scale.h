// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how dense a cloud is, and from how far it is a surface.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace app {

/** \brief Lengths in units of the cloud. */
struct CloudScale {
  double spacing = 0; /**< median distance to the six nearest (root mean square) */

  /** \brief Median radius of the smallest neighbourhoods that are flat, a quarter as
   * thick as wide, or else of the flattest ones. Less than that is noise, or the layers
   * of several scans. */
  double flat_radius = 0;
};

/** \brief Points of a cloud that the rest has to have, at least, to be measured. */
constexpr std::size_t least_points = 24;

/** \brief Measured around a thousand points that are evenly spread over the cloud's
 * order. \a points are finite, different, and least_points at least. */
CloudScale
measureScale(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points);

} // namespace app
