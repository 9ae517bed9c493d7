// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which pieces that grew by themselves are a surface.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief When a piece that grew by itself stays. */
struct ComponentRule {
  std::size_t minimum_internal_points = 10; /**< N_i */
  /** \brief Median fold of a surface that is to be trusted, in radians; 0 to take it
   * from the largest piece. */
  double typical_fold = 0.0;
};

/** \brief Of the triangles that a growth has made, those that stay: pieces that grew
 * from a seed and never met the rim must have enough internal points (C3.4-3) and not
 * be crumpled, by which connected outliers betray themselves (see doubtfulTriangles()).
 *
 * \param[in] triangles the rim, then the new ones
 * \param[in] rim number of rim triangles
 * \param[in] positions of the vertices
 * \param[in] rule when a piece lasts */
Triangles
largeComponents(const Triangles& triangles,
                std::size_t rim,
                const Positions& positions,
                const ComponentRule& rule);

/** \brief What of a mesh lasts. */
struct LastingPieces {
  std::vector<std::uint8_t> flags; /**< of a triangle */
  std::size_t count = 0;           /**< of islands */
};

/** \brief The islands of a mesh that have enough internal points or one of the first
 * triangles.
 * \param[in] adjacency of its triangles
 * \param[in] kept number of triangles that stay in any case, with their islands */
LastingPieces
lastingPieces(const TriangleAdjacency& adjacency,
              std::size_t kept,
              std::size_t minimum_internal_points,
              const LoopContext& context = {});

} // namespace pcl::ccaa
