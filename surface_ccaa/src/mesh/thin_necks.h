// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_view.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Edges within which what is around a vertex tells whether it is on a neck. */
constexpr int EDGES_AROUND_NECK = 6;

/** \brief A place where a surface is thin. */
struct ThinNeck {
  pcl::index_t vertex = -1;         /**< one on it */
  std::vector<pcl::index_t> around; /**< vertices, with all of the ring */
  bool is_handle = false; /**< it is no neck, but has a handle as small as one */
};

/** \brief Where a surface narrows to a ring of so few edges that within four of them
 * around a vertex there is an annulus, and opens from there to both sides like a cone
 * of at least 60 degrees, as between two spheres that lie as far apart as their points.
 * No sampling tells there whether they are one body or touch each other.
 *
 * There may be openings in it, too, as where only a strip joins the two: of up to 40
 * edges the whole rim takes the place of the vertex.
 *
 * Tips, stems and tubes open to one side or to none, and are no necks; neither is where
 * within EDGES_AROUND_NECK a boundary begins that leads farther, nor the bumps of a
 * rough surface, which end within two edges of the ring. But a whole handle may lie
 * within four edges of a vertex: so small a one is told, too. Cost: some 0.15 us a
 * vertex, and 30 us for each whose angles exceed those in a plane by a radian: of noise
 * up to 3 us a vertex.
 *
 * \param[in] among the vertices that are looked at, ascending; null: all
 * \return by their vertices, ascending */
std::vector<ThinNeck>
thinNecks(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const PointView& points,
          const LoopContext& context,
          const std::vector<pcl::index_t>* among = nullptr);

} // namespace pcl::ccaa
