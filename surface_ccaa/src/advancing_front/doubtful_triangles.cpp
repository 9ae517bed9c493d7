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
sharpestTrusted(const EdgeFolds& folds, std::size_t triangles)
{
  FoldStatistics all;
  for (std::size_t t = 0; t < triangles; ++t)
    folds.addTo(all, t);
  return std::max(all.exceededBy(tuning::RARE_SHARE),
                  FoldStatistics::classOf(std::cos(tuning::SHARP_FOLD)));
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
  const std::size_t limit = sharpestTrusted(folds, triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    bool doubt = crumpled[islands[t]] != 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
      doubt =
          doubt || (folds(t, corner) != EdgeFolds::NO_FOLD && folds(t, corner) > limit);
    if (doubt)
      doubts.triangles.push_back(static_cast<index_t>(t));
  }
  return doubts;
}

} // namespace pcl::ccaa
