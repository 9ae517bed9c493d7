// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the adjacency of triangles that a chain hands on.
#pragma once

#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief An adjacency with the points of its vertices. */
struct VertexAdjacency {
  TriangleAdjacency adjacency;
  std::vector<pcl::index_t> point_of_vertex;
};

/** \brief The same for other vertices, by their points; all with triangles must be
 * among them. \param[in] point_count of the cloud */
TriangleAdjacency
adjacencyFor(const std::vector<pcl::index_t>& point_of_vertex,
             VertexAdjacency known,
             std::size_t point_count,
             int threads);

} // namespace pcl::ccaa
