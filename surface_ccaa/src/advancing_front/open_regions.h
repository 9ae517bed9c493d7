// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: gaps that have nothing to do with each other.
#pragma once

#include "advancing_front/open_surface.h"
#include "run/run_control.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Split the open points into regions between which no triangle can be made: a
 * new edge is never longer than a few spacings at its ends, so points that no chain of
 * such steps connects, and no triangle either, have nothing to do with each other.
 * Regions can be completed at the same time.
 *
 * \param[in] open with neighbors and complete spacings
 * \param[in] reach longest edge in spacings
 * \return open points of each region, ascending; regions by their first point */
std::vector<std::vector<pcl::index_t>>
openRegions(const OpenSurface& open, double reach);

/** \brief Rim triangles of each region; each belongs to one of them. */
std::vector<std::vector<pcl::index_t>>
rimOfRegions(const OpenSurface& open,
             const std::vector<std::vector<pcl::index_t>>& regions);

/** \brief One region as an open surface of its own.
 * \param[in] points of the region, ascending
 * \param[in] rim its rim triangles
 * \param[out] vertices what its vertices are in \a open
 * \param[in,out] control told the work, may be null */
OpenSurface
regionOf(const OpenSurface& open,
         const std::vector<pcl::index_t>& points,
         const std::vector<pcl::index_t>& rim,
         std::vector<pcl::index_t>& vertices,
         RunControl* control = nullptr);

} // namespace pcl::ccaa
