// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where the missing area lies, seen from a jagged boundary.

#pragma once

#include "boundary/boundary_loop.h"

namespace pcl::repair {

/** \brief At each point of a closed curve the integral of tau x n over an arc with the
 * point in its middle, brought to unit length; 0 where it vanishes. Cost: linear.
 * \param[in] window length of the arc; 0: a share of the curve's length */
Directions
smoothConormals(const BoundaryCurve& curve, double window);

} // namespace pcl::repair
