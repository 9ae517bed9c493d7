// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: triangles all around between two loops.

#pragma once

#include "filling/filling_method.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Close a ring that was cut open by triangles that have an edge of one of its
 * two loops each, so that it becomes a tube however far apart the two are: those with
 * the least total length of edges between the loops. Nothing is avoided.
 * Cost: the product of the lengths of the loops.
 * \param[in] ring its first loop once around, with its first point again at the end,
 * and then the second one
 * \param[in] second place at which the second one begins */
Filling
stitchRing(const BoundaryCurve& ring, std::size_t second);

} // namespace pcl::repair
