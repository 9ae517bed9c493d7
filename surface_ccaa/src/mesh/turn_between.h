// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the shortest turn from one direction to another.
#pragma once

#include <Eigen/Geometry>

namespace pcl::ccaa {

/** \brief As Eigen's Quaternion::FromTwoVectors(), which takes longer to compile than
 * most files: between opposites its axis comes from a singular value decomposition.
 * \param[in] from not zero \param[in] to not zero */
inline Eigen::Quaterniond
turnBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  constexpr double OPPOSITE = 1e-12; // of the sum of two unit vectors
  const Eigen::Vector3d first = from.normalized();
  const Eigen::Vector3d sum = first + to.normalized();
  const bool are_opposite = sum.norm() < OPPOSITE;
  const Eigen::Vector3d half = are_opposite ? first.unitOrthogonal() : sum.normalized();
  Eigen::Quaterniond turn;
  turn.w() = first.dot(half);
  turn.vec() = first.cross(half);
  return turn;
}

} // namespace pcl::ccaa
