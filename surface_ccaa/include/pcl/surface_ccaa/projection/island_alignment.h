// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding the given islands alike before they are joined.
#pragma once

#include <pcl/surface_ccaa/mesh/islands.h>
#include <pcl/surface_ccaa/mesh/point_view.h>
#include <pcl/surface_ccaa/mesh/triangle.h>
#include <pcl/surface_ccaa/mesh/triangle_adjacency.h>

#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Pairs of boundary points of different islands that lie next to each other. */
struct IslandContact {
  pcl::index_t one, other;
};

/** \brief Reverse islands so that neighbors agree on their outer side.
 *
 * With normals every island is wound as most of its triangles say. Without, each pair
 * of islands asks its contacts: two boundary points that lie in each other's tangent
 * planes should have like normals; sheets that face each other, as of a thin plate, do
 * not lie in each other's planes and have no say. The clearest pairs decide first,
 * around the largest island of each group.
 *
 * \param[in,out] triangles consistently wound within each island
 * \param[in] adjacency of these
 * \param[in] islands of these
 * \param[in] points of the vertices
 * \param[in] normals outward, or empty
 * \param[in] contacts in a fixed order
 * \return whether any island was reversed */
bool
alignIslands(Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const Islands& islands,
             const PointView& points,
             const PointView& normals,
             const std::vector<IslandContact>& contacts);

} // namespace ccaa
} // namespace pcl
