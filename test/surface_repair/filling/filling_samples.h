// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes to be closed, for tests.

#pragma once

#include "filling/filling_method.h"
#include "filling/minimum_weight_filling.h"
#include "mesh/intersection.h"
#include "support/random_source.h"
#include "support/shapes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::repair::test {

/** \brief The hole of a surface given by height over the plane, above a star-shaped
 * outline: the surface lies outside, on the left of the polygon. */
struct HoleShape {
  std::size_t points = 24;
  std::function<double(double x, double y)> height = [](double, double) { return 0.0; };
  double roughness = 0.0; /**< of the radius, which is 1 */
};

/** \brief Normal of the surface z = height(x, y), upward. */
inline Direction
normalOf(const HoleShape& shape, const Position& p)
{
  const double h = 1e-6;
  return Direction((shape.height(p.x() - h, p.y()) - shape.height(p.x() + h, p.y())) /
                       (2.0 * h),
                   (shape.height(p.x(), p.y() - h) - shape.height(p.x(), p.y() + h)) /
                       (2.0 * h),
                   1.0)
      .normalized();
}

/** \brief Clockwise seen from above, so that the surface around is on the left. */
inline FillingTask
holeIn(const HoleShape& shape)
{
  FillingTask task;
  ccaa::test::RandomSource random(shape.points);
  for (std::size_t k = 0; k < shape.points; ++k) {
    const double angle =
        -2.0 * M_PI * static_cast<double>(k) / static_cast<double>(shape.points);
    const double radius = 1.0 + shape.roughness * random.uniform(-1.0, 1.0);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    task.polygon.points.emplace_back(x, y, shape.height(x, y));
  }
  for (std::size_t k = 0; k < shape.points; ++k)
    task.polygon.normals.push_back(normalOf(
        shape,
        0.5 * (task.polygon.points[k] + task.polygon.points[task.polygon.next(k)])));
  return task;
}

inline double
capHeight(double x, double y)
{
  return std::sqrt(std::max(0.0, 2.0 - x * x - y * y));
}

inline double
saddleHeight(double x, double y)
{
  return 0.8 * (x * x - y * y);
}

/** \brief All vertices of a filling: those of the polygon, then the inner ones. */
inline Positions
verticesOf(const FillingTask& task, const Filling& filling)
{
  Positions all = task.polygon.points;
  all.insert(all.end(), filling.inner.begin(), filling.inner.end());
  return all;
}

/** \brief Area of all triangles. */
inline double
areaOf(const FillingTask& task, const Filling& filling)
{
  const Positions all = verticesOf(task, filling);
  double area = 0.0;
  for (const Triangle& t : filling.triangles)
    area += 0.5 * ccaa::areaNormal(ccaa::cornersOf(t, all)).norm();
  return area;
}

inline Filling
fillingOf(const FillingTask& task)
{
  return MinimumWeightFilling().close(task);
}

/** \brief Pairs of triangles that meet. */
inline std::size_t
meetings(const FillingTask& task, const Filling& filling)
{
  ccaa::RunControl control;
  return ccaa::findSelfIntersections(filling.triangles, task.polygon.points, 1, control)
      .pairs.size();
}

} // namespace pcl::repair::test
