// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans that touch in one point, taken apart.

#pragma once

#include <pcl/surface_ccaa/mesh/triangle.h>
#include <pcl/surface_ccaa/mesh/triangle_adjacency.h>

#include <vector>

namespace pcl {
namespace repair {

/** \brief Triangles of which no two fans share a vertex. */
struct PointFans {
  ccaa::Triangles triangles;
  std::vector<pcl::index_t> vertices; /**< of the new vertices, which follow those that
                                           are there: which one each was */
};

/** \brief Give each fan at a vertex but the first, the one with the lowest triangle, a
 * vertex of its own. The mesh must have no overfull edges. */
PointFans
separateFans(const ccaa::Triangles& triangles,
             const ccaa::TriangleAdjacency& adjacency);

} // namespace repair
} // namespace pcl
