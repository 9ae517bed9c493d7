// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: through which parts of a surface its handles pass.
#pragma once

#include "mesh/triangle_adjacency.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief A part of a surface that handles pass through. */
struct HandlePlace {
  pcl::index_t flagged = -1; /**< its lowest flagged vertex */
  std::vector<pcl::index_t> vertices;
};

/** \brief Through which of some parts of a surface handles pass.
 *
 * The parts are the triangles at flagged vertices, as far as they are connected. Parts,
 * and the components of the rest, are the nodes of a graph whose arcs are the loops
 * between them. The genus of the surface is that of all nodes and one for each cycle
 * of that graph that is independent of the others. So a handle lies in a part of a
 * genus of its own, or closes a cycle; of the parts on a cycle that is the smallest, as
 * large ones may run all along the rim of a plate. Cost: linear.
 *
 * \param[in] adjacency of the triangles, which are a manifold and wound alike
 * \param[in] is_flagged by vertex
 * \return such parts by their flagged vertices: at most as many as the surface has
 * handles */
std::vector<HandlePlace>
handlePlaces(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const std::vector<std::uint8_t>& is_flagged,
             int threads = 1);

} // namespace pcl::ccaa
