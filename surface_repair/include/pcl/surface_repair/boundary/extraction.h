// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: walking the boundaries of a model (D4.1-2).

#pragma once

#include <pcl/surface_repair/boundary/boundary_loop.h>

namespace pcl {
namespace repair {

/** \brief All boundary loops, by the lowest boundary half-edge (3 * triangle + corner),
 * each beginning there.
 *
 * The normal of an edge is the mean of the model's vertex normals at its ends, brought
 * to unit length and made perpendicular to the edge; the triangle's where that fails;
 * any that is perpendicular where the triangle has no area either.
 * One-sided islands have no positive direction: their loops are walked as they come.
 * Cost: linear, one look at each triangle. */
BoundaryLoops
extractBoundaries(const IncompleteModel& model);

} // namespace repair
} // namespace pcl
