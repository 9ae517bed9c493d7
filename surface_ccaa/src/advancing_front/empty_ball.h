// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the smallest empty ball through the corners of a triangle.
#pragma once

#include <Eigen/Geometry>

#include "advancing_front/tuning.h"
#include "mesh/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::ccaa {

/** \brief All balls whose surface passes through the corners of a triangle, less those
 * with a witness inside.
 *
 * Their centers lie on the axis through the circumcenter, center + t * axis; each
 * witness shortens the interval of t from one side. What is left empty makes the
 * triangle a Delaunay triangle of corners and witnesses, and the smallest of the balls
 * left tells how well the samples support it. */
class EmptyBall {
public:
  EmptyBall(const Position& a, const Position& b, const Position& c)
  {
    const Position u = a - c, v = b - c;
    const Position normal = u.cross(v);
    const double squared = normal.squaredNorm();
    if (!(squared > 0.0))
      return;
    axis_ = normal / std::sqrt(squared);
    const Position to_center =
        (u.squaredNorm() * v - v.squaredNorm() * u).cross(normal) / (2.0 * squared);
    center_ = c + to_center;
    squared_radius_ = to_center.squaredNorm();
    low_ = -std::numeric_limits<double>::infinity();
    high_ = std::numeric_limits<double>::infinity();
  }

  /** \brief Leave out the balls that hold a witness. Corners must not be given. */
  void
  exclude(const Position& witness)
  {
    const Position from_center = witness - center_;
    const double power = from_center.squaredNorm() - squared_radius_;
    if (std::abs(power) <= tuning::BALL_TOLERANCE * squared_radius_)
      return; // as good as on the ball: grids are full of these
    const double height = from_center.dot(axis_);
    const double bound = power / (2.0 * height);
    if (height == 0.0)
      high_ = power < 0.0 ? -std::numeric_limits<double>::infinity() : high_;
    else if (height > 0.0)
      high_ = std::min(high_, bound);
    else
      low_ = std::max(low_, bound);
  }

  bool
  exists() const
  {
    return std::isfinite(squared_radius_) &&
           high_ > -std::numeric_limits<double>::infinity() &&
           low_ <= high_ + tuning::BALL_TOLERANCE * std::sqrt(squared_radius_);
  }

  /** \brief Radius of the circumcircle. Infinite for three points on a line. */
  double
  circumradius() const
  {
    return std::sqrt(squared_radius_);
  }

  /** \brief Radius of the smallest ball left. */
  double
  radius() const
  {
    const double offset = low_ > 0.0 ? low_ : high_ < 0.0 ? high_ : 0.0;
    return std::sqrt(squared_radius_ + offset * offset);
  }

private:
  Position center_ = Position::Zero(), axis_ = Position::Zero();
  double squared_radius_ = std::numeric_limits<double>::infinity();
  double low_ = 1.0, high_ = -1.0;
};

} // namespace pcl::ccaa
