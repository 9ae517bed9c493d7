// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points are samples of which missing area.

#pragma once

#include "field/free_point_field.h"
#include "region/region.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Give each free point to the region that it can be reached from in the
 * shortest hops, from the rim over other free points: however far it is from the rim,
 * as long as others lie between.
 *
 * None has a point close over the given surface, an outlier that no hop of the usual
 * length leads to, and where there are too few to tell a surface.
 * Cost: log-linear in the free points, linear in the triangles of the model.
 * \return of each region its free points, those near the rim first */
std::vector<std::vector<std::size_t>>
shareSamples(const IncompleteModel& model,
             const FreePointField& free_points,
             const std::vector<Region>& regions,
             ccaa::RunControl* control = nullptr);

/** \brief Regions between which samples go on: where ways from both meet at several
 * places, each region and the one that it meets most, if that is mutual.
 * \return pairs, ascending */
std::vector<std::pair<std::size_t, std::size_t>>
regionsThatSamplesLink(const IncompleteModel& model,
                       const FreePointField& free_points,
                       const std::vector<Region>& regions);

} // namespace pcl::repair
