// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how many holes and rims a mesh has.
#include "boundary_loops.h"

#include <pcl/surface_ccaa/consecutive/stage_polygons.h>
#include <pcl/surface_ccaa/mesh/triangle_adjacency.h>

#include <array>

namespace app {
namespace {

constexpr pcl::index_t NOBODY = -1;

/** The two neighbours that a point of a rim has along it; windings do not matter. */
using RimNeighbors = std::array<pcl::index_t, 2>;

void
addNeighbor(pcl::index_t neighbor, RimNeighbors& neighbors)
{
  if (neighbors[0] == NOBODY)
    neighbors[0] = neighbor;
  else
    neighbors[1] = neighbor;
}

std::vector<RimNeighbors>
findRims(const pcl::ccaa::Triangles& triangles, std::size_t point_count, int threads)
{
  pcl::ccaa::TriangleAdjacency adjacency;
  adjacency.build(triangles, point_count, threads);
  std::vector<RimNeighbors> rims(point_count, {NOBODY, NOBODY});
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      if (adjacency.across(static_cast<pcl::index_t>(i), corner) ==
          pcl::ccaa::TriangleAdjacency::NONE) {
        const auto a = triangles[i][static_cast<std::size_t>(corner)];
        const auto b = triangles[i][static_cast<std::size_t>((corner + 1) % 3)];
        addNeighbor(b, rims[static_cast<std::size_t>(a)]);
        addNeighbor(a, rims[static_cast<std::size_t>(b)]);
      }
  return rims;
}

} // namespace

std::size_t
countBoundaryLoops(const std::vector<pcl::Vertices>& triangles,
                   std::size_t point_count,
                   int threads)
{
  const pcl::ccaa::LoopContext loop{threads, nullptr, "", pcl::ccaa::BLOCK_SIZE};
  auto rims =
      findRims(pcl::ccaa::toIndexTriangles(triangles, loop), point_count, threads);
  std::size_t loops = 0;
  for (std::size_t i = 0; i < point_count; ++i) {
    if (rims[i][0] == NOBODY)
      continue;
    ++loops;
    // Walk on, wiping out the way, until nobody is ahead.
    auto here = static_cast<pcl::index_t>(i);
    while (here != NOBODY) {
      const RimNeighbors ahead = rims[static_cast<std::size_t>(here)];
      rims[static_cast<std::size_t>(here)] = {NOBODY, NOBODY};
      here = NOBODY;
      for (const pcl::index_t next : ahead)
        if (next != NOBODY && rims[static_cast<std::size_t>(next)][0] != NOBODY)
          here = next;
    }
  }
  return loops;
}

} // namespace app
