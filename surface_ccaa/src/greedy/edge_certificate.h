// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which candidate edges no other point speaks against.
#pragma once

#include "greedy/edge_votes.h"
#include "greedy/ranked_points.h"

#include <cstddef>

namespace pcl::ccaa {

/** \brief The empty-circle test of every candidate edge of a range of points.
 *
 * An edge \e ab of a planar set belongs to its Delaunay triangulation exactly when some
 * circle through \e a and \e b is empty, that is, when the widest angle under which it
 * is seen from the left and the widest from the right sum to at most pi. The test needs
 * no triangulation, so the greedy start can ask it of each edge by itself, with the k
 * neighbors of \e a as witnesses. Two certified edges of a plane never cross; where the
 * greedy order alone has to hope that the sides of a quadrilateral come before its
 * diagonals, certified edges make it so.
 *
 * On a curved surface the witnesses are laid into the regression plane of the
 * neighborhood, each at its distance along the plane, except those that stand steeper
 * than \e steepness over it: these belong to another sheet or beyond a sharp edge and
 * keep their height, so that they are seen as the farther points they are. If the whole
 * neighborhood is a thick, unlayered cloud of noise, all go into the plane.
 *
 * Results do not depend on the instruction set: no contraction, fixed order of sums.
 * Cost O(k^2) a point, about 0.15 microseconds for k = 16 with AVX2.
 *
 * \param[in] points coordinates by rank
 * \param[in] neighbors k at most 64
 * \param[in] length_factor longest edge in local spacings (see GreedyParameters)
 * \param[in] first first rank of the range
 * \param[in] last one past the last
 * \param[out] votes last - first entries */
void
certifyEdges(const RankedPoints& points,
             const NeighborRows& neighbors,
             float length_factor,
             std::size_t first,
             std::size_t last,
             EdgeVotes* votes);

} // namespace pcl::ccaa
