// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one fan for every point in the end.
#pragma once

#include "advancing_front/partial_surface.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Take triangles away until every one of some points has a single fan (C3.4-2):
 * the fan
 * with given triangles stays, else the one with the most triangles, else the one with
 * the earliest (row 3 of table T3.4-1, for points where two stretches of front were
 * left touching each other).
 *
 * \param[in] points whose fans may be several; points of removed triangles are looked
 * at as well
 * \param[in] keep_given never take a given triangle; the given mesh must then have a
 * single fan at each point \param[in,out] control told the work, may be null; after
 * cancelling some points may have several
 * \param[in] whole flags of the points all triangles of which are there: the others
 * are not looked at, and of given fans one that reaches one of these stays; null: all
 * are */
void
settleFans(PartialSurface& surface,
           const std::vector<pcl::index_t>& points,
           bool keep_given,
           RunControl* control = nullptr,
           const std::vector<std::uint8_t>* whole = nullptr);

} // namespace pcl::ccaa
