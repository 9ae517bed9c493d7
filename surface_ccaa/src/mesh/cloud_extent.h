// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how large a cloud is, and how far from the origin.
#pragma once

#include <Eigen/Geometry>

#include "mesh/point_view.h"

#include <cstddef>

namespace pcl::ccaa {

/** \brief Where the points of a cloud are, in its units. */
struct CloudExtent {
  std::size_t finite = 0;  /**< points with finite coordinates, of many about */
  Eigen::AlignedBox3d box; /**< of nearly all: stray points do not count */
  double side = 0.0;       /**< longest of the box */
  double spacing = 0.0;    /**< side over the root of the number of finite points */

  /** \brief How far rounding to float may move a coordinate. */
  double
  floatRounding() const;
};

/** \brief Measure a cloud. The box leaves out a fiftieth of the points at both ends of
 * each axis; of many points a few thousand, evenly spaced in the list, are looked at.
 * Empty for fewer than three finite points. */
CloudExtent
measureExtent(const PointView& points);

} // namespace pcl::ccaa
