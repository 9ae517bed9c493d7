// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary integral D (D4.1-1).
#include "boundary/boundary_integral.h"

#include "boundary/farthest_tree.h"
#include "boundary/smooth_conormals.h"

namespace pcl::repair {

std::vector<std::size_t>
farthestPoints(const Positions& points)
{
  std::vector<std::size_t> farthest;
  farthest.reserve(points.size());
  const FarthestTree tree(points);
  for (const Position& place : points)
    farthest.push_back(tree.farthest(place, farthest.empty() ? 0 : farthest.back()));
  return farthest;
}

BoundaryIntegral
boundaryIntegral(const BoundaryCurve& curve, double window)
{
  BoundaryIntegral integral;
  if (curve.size() < 2)
    return integral;
  const std::vector<std::size_t> farthest = farthestPoints(curve.points);
  const Directions conormals = smoothConormals(curve, window);
  double before = curve.edge(curve.size() - 1).norm();
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double after = curve.edge(k).norm();
    const double db = 0.5 * (before + after); // what the point X stands for
    const std::size_t y = farthest[k];
    const Direction chord = (curve.points[y] - curve.points[k]).normalized(); // XY
    integral.value += -conormals[y].dot(chord) * db; // cos(phi) db (ED4.1-1)
    integral.length += db;
    before = after;
  }
  return integral;
}

} // namespace pcl::repair
