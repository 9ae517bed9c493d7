// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges at which a surface is sharp.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_view.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Edges between triangles whose normals are more than 60 degrees apart, each
 * once, by the lower triangle. */
struct SharpEdges {
  std::vector<TriangleAdjacency::Edge> concave; /**< at the bottom of a groove */
  std::vector<TriangleAdjacency::Edge> convex;
};

/** \brief Cost: some 0.03 us a triangle, and 12 bytes for a while.
 * \param[in] adjacency of the triangles, which are wound alike, outward */
SharpEdges
findSharpEdges(const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points,
               const LoopContext& context);

} // namespace pcl::ccaa
