// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a connected region of new triangles.

#pragma once

#include <pcl/surface_ccaa/surface_topology.h>

#include "icadm/incomplete_model.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace pcl::repair {

/** \brief The fillings of all holes that bridges connect, as one region.
 *
 * The first vertices, as many as `rim` has, are vertices of the model: they have
 * triangles of the model too and never move. So do held ones: free points that have
 * become vertices, and vertices of creases: across these the tangent plane jumps. All
 * edges between vertices of the rim that have one triangle of the patch have one of the
 * model, too: they are never split. */
struct Patch {
  std::vector<pcl::index_t> rim; /**< vertex of the model, for the first vertices */
  Positions positions;           /**< of all vertices, those of the rim first */
  std::vector<std::size_t> free_point; /**< of all vertices: the free point that it is
                                            (held), NONE: none */
  Triangles triangles;                 /**< wound like the model */
  std::vector<std::size_t> hole;       /**< of each triangle: of which filling it is */

  /** Edges of creases, the lower vertex first: never flipped, halved at a new vertex of
   * the crease. */
  std::set<std::array<std::size_t, 2>> creases;
  std::vector<char> on_crease; /**< of the first vertices, not 0: an end of these */

  bool
  isHeld(std::size_t vertex) const
  {
    return vertex < rim.size() || free_point[vertex] != NONE || isOnCrease(vertex);
  }
  bool
  isOnCrease(std::size_t vertex) const
  {
    return vertex < on_crease.size() && on_crease[vertex] != 0;
  }
  bool
  isCrease(std::size_t a, std::size_t b) const
  {
    return creases.count({std::min(a, b), std::max(a, b)}) > 0;
  }
  void
  addCrease(std::size_t a, std::size_t b)
  {
    creases.insert({std::min(a, b), std::max(a, b)});
    on_crease.resize(std::max({on_crease.size(), a + 1, b + 1}), 0);
    on_crease[a] = on_crease[b] = 1;
  }
};

/** \brief What kind of surface a patch is by itself. Cost: linear. */
ccaa::SurfaceTopology
surfaceKindOf(const Patch& patch);

/** \brief The patch without some of its triangles, and without the vertices that only
 * these have; what is left keeps its order. \param[in] is_kept of each triangle */
Patch
keepTriangles(const Patch& patch, const std::vector<bool>& is_kept);

} // namespace pcl::repair
