// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of a patch that have next to no length.

#pragma once

#include "filling/patch.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Make one vertex of the ends of edges below a share of the patch's mean edge,
 * the shortest first, where both may move and the patch stays the surface it is: a fold
 * that hangs on three edges shrinks to a point when it is relaxed, and its triangles
 * have no area.
 *
 * Vertices keep their order, and triangles too. Cost: linear, and some operations for
 * each edge that goes. \return how many went */
std::size_t
collapseShortEdges(Patch& patch);

} // namespace pcl::repair
