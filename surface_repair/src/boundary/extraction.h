// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: walking the boundaries of a model (D4.1-2).

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <map>

namespace pcl::repair {

/** \brief All boundary loops, by the lowest boundary half-edge (3 * triangle + corner),
 * each beginning there.
 *
 * The normal of an edge is the mean of the model's vertex normals at its ends, brought
 * to unit length and made perpendicular to the edge; the triangle's where that fails;
 * any that is perpendicular where the triangle has no area either.
 * Where fans touch in a point, a loop goes on with the fan on the other side of the
 * gap: two holes that meet in a point are two loops. There an edge ends in a vertex of
 * its triangle that is another one than the next edge begins in, though the point is
 * the same; pinchedVertices() lists them. Where sheets were cut apart or touch along an
 * edge (a seam) no loop goes across, and a loop of seams alone is none: nothing is
 * missing there. One-sided islands have no positive direction:
 * their loops are walked as they come. Cost: linear, one look at each triangle. */
BoundaryLoops
extractBoundaries(const IncompleteModel& model);

/** \brief Vertices of one point that a loop passes from one to the other, so that they
 * have to become one vertex for the loop to be closed: each but the lowest, with the
 * lowest. Cost: linear in the edges of the loops. */
std::map<pcl::index_t, pcl::index_t>
pinchedVertices(const IncompleteModel& model, const BoundaryLoops& loops);

/** \brief The vertex at which the triangle of the edge before vertex k of a loop ends;
 * another one than vertex k only where the loop is pinched. */
pcl::index_t
vertexBefore(const IncompleteModel& model, const BoundaryLoop& loop, std::size_t k);

} // namespace pcl::repair
