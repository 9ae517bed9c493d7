// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: directions around a point, seen in its tangent plane.
#pragma once

#include <Eigen/Geometry>

#include "mesh/triangle.h"

#include <cmath>

namespace pcl::ccaa {

/** \brief The tangent plane at a point with a zero direction in it, in which neighbours
 * are ordered by angle (GK02). */
class TangentFrame {
public:
  /** \param[in] origin the point \param[in] normal of any length but zero
   * \param[in] zero a point whose direction is angle 0 */
  TangentFrame(const Position& origin, const Position& normal, const Position& zero)
  : origin_(origin), normal_(normal.normalized())
  {
    const Position direction = zero - origin;
    x_ = direction - direction.dot(normal_) * normal_;
    y_ = normal_.cross(x_);
  }

  /** \brief Angle of the direction to a point, counter-clockwise, in [0, 2 pi]; 2 pi
   * only by rounding, when it is the least bit less than 0. */
  double
  angle(const Position& point) const
  {
    const Position direction = point - origin_;
    const double angle = std::atan2(direction.dot(y_), direction.dot(x_));
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  }

private:
  Position origin_, normal_, x_, y_;
};

} // namespace pcl::ccaa
