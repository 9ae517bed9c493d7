// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which given triangles are not to be trusted.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/islands.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief What doubtfulTriangles() found. */
struct Doubts {
  std::vector<pcl::index_t> triangles; /**< ascending */
  std::vector<pcl::index_t> folded; /**< others with an edge that folds by more than 55
                                         degrees, ascending: they may cross others */
  double typical_fold = 0.0; /**< median fold of the largest island, in radians */
};

/** \brief Triangles that pass the umbrella filter and are wrong all the same, as far as
 * their shape tells:
 * - both triangles of an edge that folds by more than 55 degrees, if folds as sharp
 *   as this are rare in the mesh (1 % of its edges, else the limit rises until they
 *   are): a start algorithm that connects two sheets which pass each other closely
 *   makes a tube with sharp ends, and every point of it has its umbrella. True sharp
 *   edges are found too and made again;
 * - islands other than the largest that are crumpled, with a median fold of more
 *   than 35 degrees and of more than 1.5 times that of the largest island: what comes
 * of connecting outliers to each other.
 *
 * \param[in] triangles consistently wound
 * \param[in] adjacency of these, without overfull edges
 * \param[in] islands of these
 * \param[in] points of the vertices
 * \return nothing of use after cancelling */
Doubts
doubtfulTriangles(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  const Islands& islands,
                  const PointView& points,
                  const LoopContext& context);

} // namespace pcl::ccaa
