// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which open points lie in space and not on a surface.
#pragma once

#include "advancing_front/open_surface.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief How far the neighbors of an open point are from lying in a plane: the ratio
 * of their least variance along any direction to their largest, 0 to 1. On a surface
 * with noise of half a spacing it stays below 0.15; between points scattered in space
 * it is mostly above. */
double
neighborhoodThickness(const OpenSurface& open, pcl::index_t point);

/** \brief One flag for each open point: scattered in space, like the outliers of a
 * scanner. These have no triangle in the rim, a thick neighborhood, and lie more than
 * 2.5 times as sparse as usual; or more than five times, however thick.
 * \param[in] usual_spacing in units of the cloud; 0 to take it from the open points */
std::vector<std::uint8_t>
findScatteredPoints(const OpenSurface& open, double usual_spacing);

} // namespace pcl::ccaa
