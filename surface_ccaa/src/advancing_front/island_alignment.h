// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding the given islands alike before they are joined.
#pragma once

#include "mesh/islands.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Pairs of boundary points of different islands that lie next to each other. */
struct IslandContact {
  pcl::index_t one, other;
};

/** \brief Reverse islands so that neighbors agree on their outer side.
 *
 * An island about which there is evidence is wound by it and never turned for the sake
 * of a neighbor: two of them that do not fit each other stay as they are, and no
 * surface can join them. About the others each pair of islands asks its contacts: two
 * boundary points that lie in each other's tangent planes should have like normals;
 * sheets that face each other, as of a thin plate, do not lie in each other's planes
 * and have no say. The clearest pairs decide first, around an island with evidence, or
 * else the largest one of each group.
 *
 * \param[in,out] triangles consistently wound within each island
 * \param[in,out] adjacency of these, which it follows
 * \param[in] islands of these
 * \param[in] points of the vertices
 * \param[in] evidence one for each island as evidentSides() has it: below 0 to turn
 * it, 0 where there is none; or empty
 * \param[in] contacts in a fixed order
 * \return whether any island was reversed */
bool
alignIslands(Triangles& triangles,
             TriangleAdjacency& adjacency,
             const Islands& islands,
             const PointView& points,
             const std::vector<double>& evidence,
             const std::vector<IslandContact>& contacts);

} // namespace pcl::ccaa
