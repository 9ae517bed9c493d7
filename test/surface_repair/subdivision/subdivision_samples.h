// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: contours to be divided, for tests.

#pragma once

#include "subdivision/hole_subdivision.h"
#include "support/random_source.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>

namespace pcl::repair::test {

/** \brief A contour from points and the normals of the surface at places; vertices are
 * numbered 0, 1, .. */
inline HolePolygon
contourOf(const Positions& points,
          const std::function<Direction(const Position&)>& normal_at)
{
  HolePolygon hole;
  hole.curve.points = points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    hole.vertices.push_back(static_cast<pcl::index_t>(k));
    hole.curve.normals.push_back(
        normal_at(0.5 * (points[k] + points[hole.curve.next(k)])));
  }
  return hole;
}

inline Direction
upward(const Position&)
{
  return Direction::UnitZ();
}

/** \brief The hole left by a cap of half angle `opening` (radians) of the unit sphere,
 * around its north pole. */
inline HolePolygon
capHole(std::size_t edges, double opening, double scale = 1.0)
{
  Positions points;
  for (std::size_t k = 0; k < edges; ++k) {
    const double a = -2.0 * M_PI * static_cast<double>(k) / static_cast<double>(edges);
    points.push_back(scale * Position(std::sin(opening) * std::cos(a),
                                      std::sin(opening) * std::sin(a),
                                      std::cos(opening)));
  }
  return contourOf(points, [](const Position& p) { return p.normalized(); });
}

/** \brief Above the circle, the saddle z = 0.8 (x^2 - y^2). */
inline HolePolygon
saddleHole(std::size_t edges)
{
  Positions points;
  for (std::size_t k = 0; k < edges; ++k) {
    const double a = -2.0 * M_PI * static_cast<double>(k) / static_cast<double>(edges);
    points.emplace_back(std::cos(a), std::sin(a), 0.8 * std::cos(2.0 * a));
  }
  return contourOf(points, [](const Position& p) {
    return Direction(-1.6 * p.x(), 1.6 * p.y(), 1.0).normalized();
  });
}

/** \brief A closed polygon through corners, clockwise seen from above, with points at
 * a spacing. */
inline HolePolygon
flatHole(const Positions& corners, double spacing)
{
  Positions points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d side = corners[(k + 1) % corners.size()] - corners[k];
    const auto pieces =
        static_cast<std::size_t>(std::max(1.0, std::round(side.norm() / spacing)));
    for (std::size_t i = 0; i < pieces; ++i)
      points.push_back(corners[k] +
                       static_cast<double>(i) / static_cast<double>(pieces) * side);
  }
  return contourOf(points, upward);
}

/** \brief Teeth like those of a comb, each 1 wide and 6 long, 1 apart. */
inline HolePolygon
combHole(int teeth)
{
  Positions corners{{0, 0, 0}};
  for (int k = 0; k < teeth; ++k) {
    corners.emplace_back(2 * k, 7, 0);
    corners.emplace_back(2 * k + 1, 7, 0);
    if (k + 1 == teeth)
      break;
    corners.emplace_back(2 * k + 1, 1, 0);
    corners.emplace_back(2 * k + 2, 1, 0);
  }
  corners.emplace_back(2 * teeth - 1, 0, 0);
  return flatHole(corners, 0.25);
}

/** \brief A band wound into a spiral of two turns. */
inline HolePolygon
spiralHole()
{
  Positions inner, outer;
  for (int k = 0; k <= 120; ++k) {
    const double a = 4.0 * M_PI * k / 120.0, r = 1.0 + 0.3 * a;
    inner.emplace_back(r * std::cos(a), r * std::sin(a), 0.0);
    outer.emplace_back((r + 0.8) * std::cos(a), (r + 0.8) * std::sin(a), 0.0);
  }
  inner.insert(inner.end(), outer.rbegin(), outer.rend());
  return flatHole(inner, 0.2);
}

inline DividedHole
divided(const HolePolygon& hole, std::size_t simple_edges, int threads = 1)
{
  SurveyParameters parameters;
  parameters.simple_edges = simple_edges;
  ccaa::LoopContext context;
  context.threads = threads;
  context.block_size = 1;
  return divideHole(
      hole, static_cast<pcl::index_t>(hole.size()), parameters, {}, context);
}

/** \brief How often the parts run through each edge, by direction. */
inline std::map<std::pair<pcl::index_t, pcl::index_t>, int>
passagesOf(const std::vector<HolePolygon>& parts)
{
  std::map<std::pair<pcl::index_t, pcl::index_t>, int> passages;
  for (const HolePolygon& part : parts)
    for (std::size_t k = 0; k < part.size(); ++k)
      ++passages[{part.vertices[k], part.vertices[part.curve.next(k)]}];
  return passages;
}

} // namespace pcl::repair::test
