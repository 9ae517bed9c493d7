// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether given triangles are a mesh that can be completed.
#include "advancing_front/partial_mesh_check.h"

#include <cstdint>

namespace pcl {
namespace ccaa {
namespace {

/** Whether the next triangle over an edge runs through it the other way. */
bool
isWoundLike(const Triangle& triangle, int corner, const Triangle& other)
{
  const pcl::index_t from = triangle[static_cast<std::size_t>(corner)];
  const pcl::index_t to = triangle[static_cast<std::size_t>((corner + 1) % 3)];
  for (std::size_t i = 0; i < 3; ++i)
    if (other[i] == to && other[(i + 1) % 3] == from)
      return true;
  return false;
}

/** One flag for each triangle: it disagrees with a neighbor about the winding. */
std::vector<std::uint8_t>
findDisagreements(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  const LoopContext& context)
{
  std::vector<std::uint8_t> disagrees(triangles.size(), 0);
  forEachBlock(triangles.size(), context, [&](auto, auto begin, auto end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other =
            adjacency.across(static_cast<pcl::index_t>(t), corner);
        if (other >= 0 && !isWoundLike(triangles[t],
                                       corner,
                                       triangles[static_cast<std::size_t>(other)]))
          disagrees[t] = 1;
      }
  });
  return disagrees;
}

} // namespace

PartialMeshFault
findFault(const TriangleAdjacency& adjacency)
{
  if (!adjacency.overfullEdges().empty())
    return PartialMeshFault::NON_MANIFOLD_EDGE;
  for (const Fan fan : adjacency.fans())
    if (fan == Fan::SEVERAL || fan == Fan::OVERFULL)
      return PartialMeshFault::NON_MANIFOLD_VERTEX;
  return PartialMeshFault::NONE;
}

std::vector<pcl::index_t>
disagreeingIslands(const Triangles& triangles,
                   const TriangleAdjacency& adjacency,
                   const Islands& islands,
                   const LoopContext& context)
{
  const std::vector<std::uint8_t> disagrees =
      findDisagreements(triangles, adjacency, context);
  std::vector<std::uint8_t> in_island(islands.count, 0);
  for (std::size_t t = 0; t < disagrees.size(); ++t)
    if (disagrees[t] != 0)
      in_island[islands[t]] = 1;
  std::vector<pcl::index_t> found;
  for (std::size_t t = 0; t < disagrees.size(); ++t)
    if (in_island[islands[t]] != 0)
      found.push_back(static_cast<pcl::index_t>(t));
  return found;
}

} // namespace ccaa
} // namespace pcl
