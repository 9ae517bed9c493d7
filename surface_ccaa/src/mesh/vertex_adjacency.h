// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the adjacency of triangles that a chain hands on.
#pragma once

#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief An adjacency with the points of its vertices. */
struct VertexAdjacency {
  TriangleAdjacency adjacency;
  std::vector<pcl::index_t> point_of_vertex;
};

} // namespace pcl::ccaa
