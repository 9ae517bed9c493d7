// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which given triangles are not to be trusted.
#include "advancing_front/doubtful_triangles.h"

#include "advancing_front/fold_statistics.h"
#include "advancing_front/tuning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::ccaa {
namespace {

/** Highest class of folds that are not doubtful. */
std::size_t
sharpestTrusted(const EdgeFolds& folds, std::size_t triangles, std::size_t sharp)
{
  FoldStatistics all;
  for (std::size_t t = 0; t < triangles; ++t)
    folds.addTo(all, t);
  return std::max(all.exceededBy(tuning::RARE_SHARE), sharp);
}

bool
foldsAbove(const EdgeFolds& folds, std::size_t triangle, std::size_t limit)
{
  for (std::size_t corner = 0; corner < 3; ++corner)
    if (const auto fold = folds(triangle, corner);
        fold != EdgeFolds::NO_FOLD && fold > limit)
      return true;
  return false;
}

} // namespace

Doubts
doubtfulTriangles(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  const Islands& islands,
                  const PointView& points,
                  const LoopContext& context)
{
  const EdgeFolds folds(triangles, adjacency, points, context);
  if (context.cancelled())
    return {};
  const std::vector<FoldStatistics> by_island = foldsByIsland(folds, islands);
  Doubts doubts;
  if (by_island.empty())
    return doubts;
  doubts.typical_fold = by_island[largestIsland(by_island)].median();
  std::vector<std::uint8_t> crumpled;
  for (const FoldStatistics& island : by_island)
    crumpled.push_back(island.median() > crumpledFold(doubts.typical_fold));
  const std::size_t sharp = FoldStatistics::classOf(std::cos(tuning::SHARP_FOLD));
  const std::size_t limit = sharpestTrusted(folds, triangles.size(), sharp);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (crumpled[islands[t]] != 0 || foldsAbove(folds, t, limit))
      doubts.triangles.push_back(static_cast<index_t>(t));
    else if (foldsAbove(folds, t, sharp))
      doubts.folded.push_back(static_cast<index_t>(t));
  return doubts;
}

} // namespace pcl::ccaa
