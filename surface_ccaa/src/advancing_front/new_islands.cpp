// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which pieces that grew by themselves are a surface.
#include "advancing_front/new_islands.h"

#include "advancing_front/fold_statistics.h"
#include "mesh/islands.h"

#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl::ccaa {
namespace {

/** Internal points of each island. */
std::vector<std::size_t>
countInternalPoints(const TriangleAdjacency& adjacency, const Islands& islands)
{
  std::vector<std::size_t> internal(islands.count, 0);
  for (std::size_t v = 0; v < adjacency.vertexCount(); ++v) {
    const auto vertex = static_cast<index_t>(v);
    if (adjacency.fan(vertex) == Fan::CLOSED)
      ++internal[islands[static_cast<std::size_t>(*adjacency.begin(vertex))]];
  }
  return internal;
}

} // namespace

Triangles
largeComponents(const Triangles& triangles,
                std::size_t rim,
                const Positions& positions,
                const ComponentRule& rule)
{
  TriangleAdjacency adjacency;
  adjacency.build(triangles, positions.size());
  const Islands islands = labelIslands(adjacency);
  const EdgeFolds folds(triangles, adjacency, positions, {});
  const std::vector<FoldStatistics> by_island = foldsByIsland(folds, islands);
  if (by_island.empty())
    return {};
  const double typical = rule.typical_fold > 0.0
                             ? rule.typical_fold
                             : by_island[largestIsland(by_island)].median();
  const std::vector<std::size_t> internal = countInternalPoints(adjacency, islands);
  std::vector<std::uint8_t> lasts(islands.count, 0);
  for (std::size_t island = 0; island < islands.count; ++island)
    lasts[island] = internal[island] >= rule.minimum_internal_points &&
                    by_island[island].median() <= crumpledFoldOfGrowth(typical);
  for (std::size_t t = 0; t < rim; ++t)
    lasts[islands[t]] = 1;
  Triangles large;
  for (std::size_t t = rim; t < triangles.size(); ++t)
    if (lasts[islands[t]] != 0)
      large.push_back(triangles[t]);
  return large;
}

LastingPieces
lastingPieces(const TriangleAdjacency& adjacency,
              std::size_t kept,
              std::size_t minimum_internal_points,
              const LoopContext& context)
{
  const Islands islands = labelIslands(adjacency, context);
  const std::vector<std::size_t> internal = countInternalPoints(adjacency, islands);
  std::vector<std::uint8_t> lasts(islands.count, 0);
  for (std::size_t island = 0; island < islands.count; ++island)
    lasts[island] = internal[island] >= minimum_internal_points;
  for (std::size_t t = 0; t < kept; ++t)
    lasts[islands[t]] = 1;
  LastingPieces pieces;
  pieces.count = std::accumulate(lasts.begin(), lasts.end(), std::size_t{0});
  pieces.flags.reserve(islands.of_triangle.size());
  for (std::size_t t = 0; t < islands.of_triangle.size(); ++t)
    pieces.flags.push_back(lasts[islands[t]]);
  return pieces;
}

} // namespace pcl::ccaa
