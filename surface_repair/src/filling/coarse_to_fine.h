// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: long polygons triangulated at some of their points first.

#pragma once

#include "filling/triangulation_table.h"

namespace pcl::repair {

/** \brief The table that has the triangulation of least weight of a polygon.
 *
 * A polygon of more than 160 points is triangulated at every second point first (and
 * this one likewise). Then only diagonals near those found are looked at, which may
 * miss the very best one. What is passed must outlive the table. */
TriangulationTable
triangulateCoarseToFine(const BoundaryCurve& polygon,
                        const FillingWeights& weights,
                        const FillingLimits& limits);

/** \brief Whether all triangulations of a polygon of so many points are looked at. */
bool
areAllLookedAt(std::size_t points);

} // namespace pcl::repair
