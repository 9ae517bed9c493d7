// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what kind of surface a mesh is, whatever its shape.
#pragma once

#include <cstddef>
#include <optional>

namespace pcl::ccaa {

/** \brief Pieces, openings and handles of a surface. */
struct SurfaceTopology {
  std::size_t pieces = 0;         /**< connected over edges */
  std::size_t boundary_loops = 0; /**< openings; of what is no manifold: connected sets
                                       of edges with one triangle */
  long euler_characteristic = 0;  /**< used vertices - edges + triangles */
  /** \brief Handles of all pieces together, each opening closed by a disc: pieces -
   * (euler_characteristic + boundary_loops) / 2. None of what is no manifold or not
   * wound alike. */
  std::optional<long> genus;
  bool is_manifold = true; /**< two triangles an edge, one fan a vertex, at the most */
  bool is_wound_alike = true; /**< no edge is run through twice in the same direction */

  /** \brief It encloses a volume: manifold, wound alike, and no opening. */
  bool
  isWatertight() const
  {
    return pieces > 0 && is_manifold && is_wound_alike && boundary_loops == 0;
  }
};

} // namespace pcl::ccaa
