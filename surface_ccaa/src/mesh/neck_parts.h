// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which parts of a surface are necks between others.
#pragma once

#include "mesh/point_view.h"
#include "mesh/triangle_adjacency.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Which parts of a surface are necks between what is wide.
 *
 * Parts are those of PartGraph. One is a neck if it alone connects one side of the
 * surface with the others, and that side and all that is not have at least six times
 * the area of a disc as large as the loops between them. So a bulge is none; neither is
 * a groove around a cylinder: a disc in it would be as large as its ends. Openings of
 * up to 63 edges do not connect what is beside them. Where one side is made of more
 * than 200 parts and components, and the largest component is on the other, nothing is
 * told. Cost: linear, up to 200 nodes for each component beside each part.
 *
 * \param[in] adjacency of the triangles, which are a manifold and wound alike
 * \param[in] is_flagged by vertex
 * \return the vertices of each, ascending, by their lowest */
std::vector<std::vector<pcl::index_t>>
neckParts(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const PointView& points,
          const std::vector<std::uint8_t>& is_flagged,
          int threads = 1);

} // namespace pcl::ccaa
