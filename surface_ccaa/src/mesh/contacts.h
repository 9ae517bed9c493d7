// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed pieces of a surface that touch others.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_view.h"
#include "mesh/triangle_adjacency.h"

#include <array>
#include <vector>

namespace pcl::ccaa {

/** \brief A point of a closed piece, and one of another piece that lies within the mean
 * length of the edges at it. */
using Contact = std::array<pcl::index_t, 2>;

/** \brief Where pieces touch, by the first point: as few contacts as join all that do.
 * No sampling tells there whether they are one body, of which a thin neck was cut.
 * Cost: next to nothing for one piece, else some 20 ns a triangle, and a search for
 * each point of a closed piece in the box of another one. */
std::vector<Contact>
pieceContacts(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const PointView& points,
              const LoopContext& context);

} // namespace pcl::ccaa
