// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary integral D (D4.1-1).

#pragma once

#include <pcl/surface_repair/model_findings.h>

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

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

} // namespace pcl::repair
