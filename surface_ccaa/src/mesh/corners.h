// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a triangle in space.
#pragma once

#include <Eigen/Geometry>

#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <array>

namespace pcl::ccaa {

/** \brief The three corners of a triangle in space. */
using Corners = std::array<Position, 3>;

inline Corners
cornersOf(const Triangle& triangle, const PointView& positions)
{
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}

/** \brief Normal on the side from which the corners run counter-clockwise, as long as
 * twice the area. */
inline Position
areaNormal(const Corners& corners)
{
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/** \brief The same, but of length 1; zero where the triangle has no area. */
inline Position
unitNormal(const Corners& corners)
{
  return areaNormal(corners).normalized();
}

} // namespace pcl::ccaa
