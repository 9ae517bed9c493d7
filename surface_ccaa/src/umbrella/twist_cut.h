// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: finds the wrong triangles that make a region one-sided.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Settings of findTwists(). */
struct TwistLimits {
  /** \brief An edge bends when the normals of its two triangles, wound alike, differ by
   * more than this, in radians. */
  double smooth_angle = 0.5235987755982988; // 30 degrees
  /** \brief Largest share of a region's triangles that a cut may cost, 0 to 1. */
  double largest_share = 0.1;
};

/** \brief The triangles that turn one-sided regions over.
 *
 * A few wrong triangles that connect two sheets the wrong way round make a whole region
 * one-sided although each of its points has a perfect umbrella. The surface of an
 * object is not (D1.3-1), so somewhere along such a way a triangle is wrong. Windings
 * are carried over the smooth edges first and then over the others as most of these
 * tell between two regions (joinClearest()); an edge whose triangles then disagree lies
 * where the surface is turned over, and the one of them that continues its neighbors
 * less evenly is named. If the least bent edge came first, whatever the others tell,
 * one wrong triangle would turn a patch of thousands over, with a crack around it.
 *
 * A region that is turned over along smooth edges alone, like a Moebius band, is truly
 * one-sided, and one that could be cut only at the price of more than
 * TwistLimits::largest_share of it is not understood: of both nothing is named.
 *
 * Cost: linear in the triangles, and O(n log^2 n) in the bent edges, 1 us each. The
 * same result for any number of threads; ties go by triangle index.
 *
 * \param[in] triangles the mesh, without overfull edges
 * \param[in] adjacency of the triangles
 * \param[in] positions of the vertices
 * \param[in] limits settings
 * \param[in] context how to run
 * \return triangles whose deletion makes these regions two-sided; none when all regions
 * are two-sided, and after cancelling */
std::vector<index_t>
findTwists(const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const Positions& positions,
           const TwistLimits& limits,
           const LoopContext& context);

} // namespace pcl::ccaa
