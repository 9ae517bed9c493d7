// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what kind of surface a mesh is, whatever its shape.
#include "mesh/surface_topology.h"

#include "mesh/disjoint_sets.h"
#include "mesh/islands.h"
#include "mesh/sort_unique.h"
#include "mesh/winding.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pcl::ccaa {
namespace {

using Border = std::array<pcl::index_t, 2>;

/** \brief What the edges of some triangles add up to. */
struct EdgeCount {
  std::size_t half_edges = 0; /**< twice the edges of one or two triangles */
  bool is_wound_alike = true;
  std::vector<Border> borders; /**< edges with one triangle */
};

void
countEdges(std::size_t triangle,
           const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           EdgeCount& sum)
{
  const auto index = static_cast<pcl::index_t>(triangle);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const pcl::index_t from = triangles[triangle][corner];
    const pcl::index_t to = triangles[triangle][(corner + 1) % 3];
    const pcl::index_t other = adjacency.across(index, static_cast<int>(corner));
    if (other == TriangleAdjacency::NONE)
      sum.borders.push_back({from, to});
    sum.half_edges += other == TriangleAdjacency::NONE ? 2 : other >= 0 ? 1 : 0;
    if (disagreesAcross(triangles, adjacency, index, static_cast<int>(corner)))
      sum.is_wound_alike = false;
  }
}

/** \brief In how many sets such edges connect vertices. */
std::size_t
countOpenings(const std::vector<Border>& borders)
{
  std::vector<pcl::index_t> vertices;
  for (const Border& border : borders)
    vertices.insert(vertices.end(), border.begin(), border.end());
  sortUnique(vertices);
  const auto place = [&](pcl::index_t vertex) {
    return static_cast<std::size_t>(
        std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  };
  DisjointSets sets(vertices.size());
  for (const Border& border : borders)
    sets.join(place(border[0]), place(border[1]));
  return sets.count();
}

} // namespace

SurfaceTopology
topologyOf(const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           std::size_t pieces,
           const LoopContext& context)
{
  std::vector<EdgeCount> counts(context.blockCount(triangles.size()));
  forEachBlock(triangles.size(), context, [&](auto block, auto begin, auto end) {
    for (std::size_t t = begin; t < end; ++t)
      countEdges(t, triangles, adjacency, counts[block]);
  });
  SurfaceTopology topology;
  std::size_t half_edges = 0;
  std::vector<Border> borders;
  for (const EdgeCount& part : counts) {
    half_edges += part.half_edges;
    topology.is_wound_alike = topology.is_wound_alike && part.is_wound_alike;
    borders.insert(borders.end(), part.borders.begin(), part.borders.end());
  }
  const auto& fans = adjacency.fans();
  const auto count = [&](Fan fan) { return std::count(fans.begin(), fans.end(), fan); };
  topology.is_manifold = count(Fan::SEVERAL) + count(Fan::OVERFULL) == 0;
  topology.pieces = pieces;
  topology.boundary_loops = countOpenings(borders);
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

SurfaceTopology
topologyOf(const Triangles& triangles, const TriangleAdjacency& adjacency)
{
  return topologyOf(triangles, adjacency, labelIslands(adjacency).count, {});
}

} // namespace pcl::ccaa
