// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what kind of surface a mesh is, whatever its shape.
#include "mesh/surface_topology.h"

#include "mesh/disjoint_sets.h"
#include "mesh/islands.h"
#include "mesh/mesh_part.h"

#include <algorithm>

namespace pcl {
namespace ccaa {
namespace {

/** \brief The vertices of edges with one triangle, in sets that such edges connect. */
class Openings {
public:
  explicit Openings(std::size_t vertices) : sets_(vertices), is_used_(vertices, false)
  {}

  void
  addEdge(pcl::index_t a, pcl::index_t b)
  {
    sets_.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    is_used_[static_cast<std::size_t>(a)] = is_used_[static_cast<std::size_t>(b)] =
        true;
  }

  std::size_t
  count()
  {
    std::size_t sets = 0;
    for (std::size_t v = 0; v < is_used_.size(); ++v)
      sets += is_used_[v] && sets_.isRoot(v) ? 1 : 0;
    return sets;
  }

private:
  DisjointSets sets_;
  std::vector<bool> is_used_;
};

} // namespace

SurfaceTopology
topologyOf(const Triangles& triangles, const TriangleAdjacency& adjacency)
{
  SurfaceTopology topology;
  Openings openings(adjacency.vertexCount());
  std::size_t half_edges = 0; // twice the edges of one or two triangles
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const pcl::index_t from = triangles[t][corner];
      const pcl::index_t to = triangles[t][(corner + 1) % 3];
      const pcl::index_t other =
          adjacency.across(static_cast<pcl::index_t>(t), static_cast<int>(corner));
      if (other == TriangleAdjacency::NONE)
        openings.addEdge(from, to);
      half_edges += other == TriangleAdjacency::NONE ? 2 : other >= 0 ? 1 : 0;
      if (other >= 0 &&
          runsAlong(triangles[static_cast<std::size_t>(other)], from, to) != 0)
        topology.is_wound_alike = false;
    }
  const auto& fans = adjacency.fans();
  const auto count = [&](Fan fan) { return std::count(fans.begin(), fans.end(), fan); };
  topology.is_manifold = count(Fan::SEVERAL) + count(Fan::OVERFULL) == 0;
  topology.pieces = labelIslands(adjacency).count;
  topology.boundary_loops = openings.count();
  topology.euler_characteristic =
      static_cast<long>(fans.size()) - static_cast<long>(count(Fan::NONE)) -
      static_cast<long>(half_edges / 2 + adjacency.overfullEdges().size()) +
      static_cast<long>(triangles.size());
  if (topology.pieces > 0 && topology.is_manifold && topology.is_wound_alike)
    topology.genus =
        static_cast<long>(topology.pieces) -
        (topology.euler_characteristic + static_cast<long>(topology.boundary_loops)) /
            2;
  return topology;
}

} // namespace ccaa
} // namespace pcl
