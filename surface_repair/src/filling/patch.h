// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a connected region of new triangles.

#pragma once

#include "icadm/incomplete_model.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief The fillings of all holes that bridges connect, as one region.
 *
 * The first vertices, as many as `rim` has, are vertices of the model: they have
 * triangles of the model too and never move. So do held ones: free points that have
 * become vertices. All edges between vertices of the rim that have one triangle of the
 * patch have one of the model, too: they are never split. */
struct Patch {
  std::vector<pcl::index_t> rim; /**< vertex of the model, for the first vertices */
  Positions positions;           /**< of all vertices, those of the rim first */
  std::vector<std::size_t> free_point; /**< of all vertices: the free point that it is
                                            (held), NONE: none */
  Triangles triangles;                 /**< wound like the model */
  std::vector<std::size_t> hole;       /**< of each triangle: of which filling it is */

  bool
  isHeld(std::size_t vertex) const
  {
    return vertex < rim.size() || free_point[vertex] != NONE;
  }
};

} // namespace pcl::repair
