// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles that see the same place make of it alike.
#pragma once

#include "tiles/tiling.h"

#include <vector>

namespace pcl::ccaa {

/** \brief What a tile made of the places where it meets others. */
struct BorderMesh {
  BorderPoints points; /**< all that it knows near other tiles, and all corners */
  std::vector<WideTriangle> triangles; /**< of which a corner is near other tiles */
};

/** \brief What is certain of the triangles that belong to a tile: those of which it has
 * the lowest corner. */
struct Agreed {
  std::vector<WideTriangle> triangles; /**< of the border; the other ones all stay */
  std::vector<WideTriangle> refused;   /**< of the border: corners in order, ascending,
                                          once each */
};

/** \brief Keep of the triangles of a tile those that every tile has that sees all three
 * corners, and which the tiles of the three corners see.
 *
 * So all kept triangles at a point are in the mesh of the tile to which the point
 * belongs: where each tile's mesh is manifold, so is the union, up to fans that were
 * cut. And as no triangle near a cut is longer than Tile::LONGEST of the halo, or of
 * that of each corner if these are sparse, some tile has any two that could cross. A
 * tile with nothing but the whole cloud keeps all.
 *
 * \param[in] tile number of the tile \param[in] own what it made
 * \param[in] others what each of its neighbors made (Tiling::neighborsOf()), as far as
 * the lowest corner is the tile's */
Agreed
agree(const Tiling& tiling,
      std::size_t tile,
      const BorderMesh& own,
      const std::vector<std::vector<WideTriangle>>& others);

/** \brief A point at which a triangle was refused. */
struct Dispute {
  WideIndex index = 0;
  Eigen::Vector3f position = Eigen::Vector3f::Zero(); /**< relative to any origin */
  float room =
      0.0F; /**< within which what closes it has to lie, in units of the cloud */
};

/** \brief Numbers the groups of disputes that may have to do with each other: those
 * with a chain of disputes between them, each less than twice the larger room from the
 * next, so that what closes two groups never meets. By the first dispute of each group.
 * Cost: n log n. */
std::vector<std::size_t>
groupDisputes(const std::vector<Dispute>& disputes);

} // namespace pcl::ccaa
