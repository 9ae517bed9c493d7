// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the adjacency of triangles that a chain hands on.
#include "mesh/vertex_adjacency.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcl::ccaa {

TriangleAdjacency
adjacencyFor(const std::vector<pcl::index_t>& point_of_vertex,
             VertexAdjacency known,
             std::size_t point_count,
             int threads)
{
  std::vector<pcl::index_t> vertex_of_point(point_count, -1);
  for (std::size_t v = 0; v < known.point_of_vertex.size(); ++v)
    vertex_of_point[static_cast<std::size_t>(known.point_of_vertex[v])] =
        static_cast<pcl::index_t>(v);
  std::vector<pcl::index_t> before;
  before.reserve(point_of_vertex.size());
  std::transform(
      point_of_vertex.begin(),
      point_of_vertex.end(),
      std::back_inserter(before),
      [&](auto point) { return vertex_of_point[static_cast<std::size_t>(point)]; });
  known.adjacency.renumber(before, threads);
  return std::move(known.adjacency);
}

} // namespace pcl::ccaa
