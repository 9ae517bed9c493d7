// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: resampling boundaries to field sources (4.46).

#pragma once

#include "field/field_source.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Resample a closed curve to sources at equal distances along it.
 *
 * Tangent and normal are those of the smoothed curve: the mean over one spacing around
 * the source, so that a jagged boundary has the direction it has as a whole.
 * \param[in] spacing wanted arc length between sources, above 0; 0: the curve's own
 *            mean edge length. At least 8 sources are made. */
SourceCurve
sampleSources(const BoundaryCurve& curve, double spacing = 0.0);

/** \brief The loops whose sources step ICM3 -> ICM2 takes: every rim, and every hole
 * whose effective size reaches that of the smallest island within `reach` of it
 * (C4.46-1). The effective size of a boundary is its extent: the diagonal of its box.
 * \param[in] is_hole one flag a loop
 * \param[in] reach L_2, in the units of the cloud
 * \param[in] least_hole share of the island's size that the hole must reach */
std::vector<bool>
areIslandSources(const BoundaryLoops& loops,
                 const std::vector<bool>& is_hole,
                 double reach,
                 double least_hole = 1.0);

/** \brief Put curves together and set their charges for equal linear density. */
SourceSet
gatherSources(std::vector<SourceCurve> curves);

} // namespace pcl::repair
