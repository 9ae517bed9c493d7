// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed pieces of a surface that touch others.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_view.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>

namespace pcl::ccaa {

/** \brief How many pieces fewer there would be, if those were one that touch: a point
 * of a closed piece lies within the mean length of the edges at it of a point of
 * another piece. No sampling tells there whether they are one body, of which a thin
 * neck was cut. Cost: next to nothing for one piece, else some 20 ns a triangle, and a
 * search for each point of a closed piece in the box of another one. */
std::size_t
touchingPieces(const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points,
               const LoopContext& context);

} // namespace pcl::ccaa
