// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a triangle in space.
#pragma once

#include <Eigen/Geometry>

#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief The three corners of a triangle in space. */
using Corners = std::array<Position, 3>;

inline Corners
cornersOf(const Triangle& triangle, const PointView& positions)
{
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}

/** \brief The corners of each of some triangles. */
inline std::vector<Corners>
cornersOf(const Triangles& triangles, const PointView& positions)
{
  std::vector<Corners> corners;
  corners.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
    corners.push_back(cornersOf(triangle, positions));
  return corners;
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

/** \brief Between two vectors of any length, radians, 0 to pi; exact near both ends. */
inline double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** \brief The same to 1e-4, at a quarter of the cost (Abramowitz and Stegun 4.4.45). */
inline double
roughAngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const double cosine = a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm());
  const double x = std::min(std::abs(cosine), 1.0);
  const double angle = std::sqrt(1.0 - x) *
                       (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
  return cosine < 0.0 ? M_PI - angle : angle;
}

/** \brief The two edges of a triangle at one of its vertices, as it winds. */
inline std::array<Position, 2>
edgesAt(const Triangle& triangle, pcl::index_t vertex, const PointView& positions)
{
  const auto corner = static_cast<std::size_t>(cornerOf(triangle, vertex));
  const Position apex = positions[vertex];
  return {positions[triangle[(corner + 1) % 3]] - apex,
          positions[triangle[(corner + 2) % 3]] - apex};
}

/** \brief Of a triangle, at one of its vertices, radians. */
inline double
angleAt(const Triangle& triangle, pcl::index_t vertex, const PointView& positions)
{
  const auto [one, other] = edgesAt(triangle, vertex, positions);
  return angleBetween(one, other);
}

/** \brief Of the edges of the first `count` triangles, those that two share twice.
 * \param[in] count above 0 */
inline double
meanEdge(const Triangles& triangles, std::size_t count, const Positions& positions)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t c = 0; c < 3; ++c)
      sum += (positions[static_cast<std::size_t>(triangles[t][c])] -
              positions[static_cast<std::size_t>(triangles[t][(c + 1) % 3])])
                 .norm();
  return sum / (3.0 * static_cast<double>(count));
}

} // namespace pcl::ccaa
