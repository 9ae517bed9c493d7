// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: long polygons triangulated at some of their points first.

#pragma once

#include "filling/triangulation_table.h"

namespace pcl {
namespace repair {

/** \brief The triangulation of least weight of a polygon.
 *
 * A polygon of more than 160 points is triangulated at every second point first (and
 * this one likewise). Then only diagonals near those found are looked at, which may
 * miss the very best one.
 * \return n - 2 triangles; none when none is allowed, or found */
Triangles
triangulateCoarseToFine(const BoundaryCurve& polygon,
                        const FillingWeights& weights,
                        const FillingLimits& limits);

} // namespace repair
} // namespace pcl
