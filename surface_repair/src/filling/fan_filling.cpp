// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by a fan around its centre (4.7).

#include "filling/fan_filling.h"

namespace pcl::repair {

namespace {

/** Centre of mass of the boundary as a wire, so that it does not depend on where the
 * boundary has its points. */
Position
centreOf(const BoundaryCurve& polygon)
{
  const double length = lengthOf(polygon);
  Position centre = Position::Zero();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Position middle = 0.5 * (polygon.points[k] + polygon.points[polygon.next(k)]);
    const double share = length > 0.0 ? polygon.edge(k).norm() / length
                                      : 1.0 / static_cast<double>(polygon.size());
    centre += share * (middle - polygon.points.front());
  }
  return polygon.points.front() + centre;
}

} // namespace

Filling
FanFilling::close(const FillingTask& task) const
{
  Filling filling;
  const std::size_t n = task.polygon.size();
  if (n < 3) {
    filling.problem = "the hole has fewer than three edges";
    return filling;
  }
  if (n == 3) {
    filling.triangles.push_back({2, 1, 0});
    return filling;
  }
  filling.inner.push_back(centreOf(task.polygon));
  filling.free_point.push_back(NONE);
  for (std::size_t k = 0; k < n; ++k)
    filling.triangles.push_back({static_cast<pcl::index_t>(task.polygon.next(k)),
                                 static_cast<pcl::index_t>(k),
                                 static_cast<pcl::index_t>(n)});
  return filling;
}

} // namespace pcl::repair
