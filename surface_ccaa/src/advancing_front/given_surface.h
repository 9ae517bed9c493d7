// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether given triangles are a mesh that can be completed.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/islands.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief What is wrong with a partial mesh. */
enum class PartialMeshFault : std::uint8_t {
  NONE,
  NON_MANIFOLD_EDGE,   /**< more than two triangles on an edge, or one of them twice */
  NON_MANIFOLD_VERTEX, /**< more than one fan at a vertex */
  BADLY_ORIENTED       /**< two triangles run through an edge in the same direction */
};

/** \brief The first fault of edges or vertices; windings are not looked at. */
PartialMeshFault
findFault(const TriangleAdjacency& adjacency);

/** \brief Triangles, ascending, of the islands in which neighbors are wound
 * differently: one-sided ones, which no object has, and those wound at random. */
std::vector<pcl::index_t>
disagreeingIslands(const Triangles& triangles,
                   const TriangleAdjacency& adjacency,
                   const Islands& islands,
                   const LoopContext& context);

} // namespace ccaa
} // namespace pcl
