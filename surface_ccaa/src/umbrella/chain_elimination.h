// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table T3.4-1 applied until every point has one chain.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_chains.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Delete triangles as table T3.4-1 says until every vertex has at most one
 * chain of live triangles (C3.4-2); C3.4-3 (row 2) is left to removeSmallRegions().
 *
 * Works in synchronous rounds, so that the result does not depend on the order of
 * points: all points under examination decide on the state at the start of the round,
 * then all triangles they rejected are deleted, and the corners of these are under
 * examination in the next round. Each round but the last deletes something, so it ends.
 *
 * \param[in] adjacency of the triangles, with no overfull edge (C3.4-1) and no triangle
 * twice
 * \param[in,out] alive flags of the triangles
 * \param[in,out] fans of the vertices: those of the adjacency before, those of the
 * live triangles (NONE, OPEN or CLOSED) after
 * \return number of triangles deleted */
std::size_t
eliminateChains(const Triangles& triangles,
                const TriangleAdjacency& adjacency,
                const Positions& positions,
                const LoopContext& context,
                AliveFlags& alive,
                std::vector<Fan>& fans);

} // namespace pcl::ccaa
