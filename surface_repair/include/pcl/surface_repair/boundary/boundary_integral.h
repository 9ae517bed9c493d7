// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary integral D (D4.1-1).

#pragma once

#include <pcl/surface_repair/boundary/boundary_loop.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace repair {

/** \brief D = sum of cos(phi) db over a boundary (ED4.1-1). */
struct BoundaryIntegral {
  double value = 0.0;  /**< D, units of length: above 0 a hole, below 0 a rim */
  double length = 0.0; /**< of the boundary */

  /** \brief D / length, -1 (flat rim) to 1 (flat hole); 0 for no boundary. */
  double
  relative() const
  {
    return length > 0.0 ? value / length : 0.0;
  }
};

/** \brief For each point of the curve the index of the point most distant from it, the
 * lowest of equals. Sub-quadratic: a tree over the points is searched with the distance
 * to the farthest point of the point before as the first bound. */
std::vector<std::size_t>
farthestPoints(const Positions& points);

/** \brief The boundary integral of a closed curve.
 *
 * The conormal at a point is that of the curve around it: the integral of tau x n over
 * a window, brought to unit length, because single edges of a scan's boundary point
 * anywhere. \param[in] window arc length over which the conormal is taken, 0: a share
 * of the curve's length that was found to be robust */
BoundaryIntegral
boundaryIntegral(const BoundaryCurve& curve, double window = 0.0);

} // namespace repair
} // namespace pcl
