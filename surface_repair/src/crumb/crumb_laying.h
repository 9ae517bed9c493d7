// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lays a crumb into the patch that covers it.

#pragma once

#include "pass/passes.h"
#include "patch/growing_surface.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Open the patch around the shadow of a crumb, its nearest triangles on the
 * side that it shows, and close the ring between opening and crumb. Where both have a
 * point of the cloud it becomes one vertex. A crumb that shows the other side
 * everywhere is turned.
 *
 * Nothing changes where no patch lies near, or where every filling runs into something.
 * Cost: some ms. \param[in] crumb triangles of a disc, ascending
 * \param[in] edge mean length of edges: a tiny triangle may lie that far from a patch
 * \return whether it is part of a patch now */
bool
layCrumb(const std::vector<std::size_t>& crumb,
         double edge,
         const Course& course,
         GrowingSurface& surface);

} // namespace pcl::repair
