// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bringing any mesh to condition C3.4-1.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_chains.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>

namespace pcl::ccaa {

/** \brief What the input lacked to meet C3.4-1. */
struct EdgeRepairReport {
  std::size_t duplicate_triangles = 0; /**< the same three corners once more: removed */
  std::size_t overfull_edges = 0;      /**< with three or more different triangles */
  std::size_t overfull_triangles = 0;  /**< removed so that no such edge remains */
};

/** \brief Delete triangles until each edge has at most two (C3.4-1) and no triangle
 * is there twice. Of equal triangles the first stays.
 *
 * On an overfull edge the most plausible pair stays. Pairs are compared by
 *   1. not folded back: the angle between the two is above 53 degrees (cosine 0.6);
 *   2. support: how many of the other edges of the two have exactly two triangles, so
 * that an umbrella can close there;
 *   3. flatness: the cosine of the angle between the two is the lowest, within 1e-9.
 * Where the best pair is not unique nothing tells right from wrong, and all triangles
 * of the edge go; so they do where there are more than MAXIMUM_WINGS. All edges decide
 * on the state after the duplicates were removed, so the order of edges, points and
 * triangles does not matter.
 *
 * The adjacency does not follow: build it again of the triangles that are left. */
EdgeRepairReport
repairNonManifoldEdges(const Triangles& triangles,
                       const TriangleAdjacency& adjacency,
                       const Positions& positions,
                       const LoopContext& context,
                       AliveFlags& alive);

} // namespace pcl::ccaa
