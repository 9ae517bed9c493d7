// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the shortest turn from one direction to another.
#include "mesh/turn_between.h"

namespace pcl::ccaa {

Eigen::Quaterniond
turnBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

} // namespace pcl::ccaa
