// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the boundary integral costs on long boundaries.
#pragma once

#include <iosfwd>

namespace bench {

/** \brief Print the time of farthestPoints() and of boundaryIntegral() for curves of
 * 1000 to 1 000 000 points: a circle, a wavy curve, and circles that are jagged in
 * their plane and in space. */
void
printBoundaryTimes(std::ostream& out);

} // namespace bench
