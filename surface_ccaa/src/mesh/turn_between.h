// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the shortest turn from one direction to another.
#pragma once

#include <Eigen/Geometry>

namespace pcl::ccaa {

/** \brief Eigen's Quaternion::FromTwoVectors(), compiled here alone: the singular value
 * decomposition in it takes longer to compile than most files. */
Eigen::Quaterniond
turnBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace pcl::ccaa
