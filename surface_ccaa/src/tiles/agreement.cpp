// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles that see the same place make of it alike.
#include "tiles/agreement.h"

#include "mesh/sort_unique.h"

#include <algorithm>

namespace pcl::ccaa {
namespace {

/** The corners that are border points. */
Positions
borderCorners(const WideTriangle& triangle, const BorderPoints& points)
{
  Positions corners;
  for (const WideIndex corner : triangle)
    if (const auto place = findPoint(points, corner); place != points.end())
      corners.push_back(place->position);
  return corners;
}

/** How many of the corners a tile sees. */
std::size_t
seenBy(const Tile& tile, const Positions& corners)
{
  return static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(), [&](const Position& corner) {
        return tile.sees(corner);
      }));
}

std::vector<WideTriangle>
sortedCorners(const std::vector<WideTriangle>& triangles)
{
  std::vector<WideTriangle> sorted;
  for (const WideTriangle& triangle : triangles)
    sorted.push_back(cornersInOrder(triangle));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/** One tile's side of the bargain. */
class Bargain {
public:
  Bargain(const Tiling& tiling,
          std::size_t tile,
          const BorderMesh& own,
          const std::vector<std::vector<WideTriangle>>& others)
  : tiling_(tiling), tile_(tile), own_(own), neighbors_(tiling.neighborsOf(tile))
  {
    for (const auto& other : others)
      others_.push_back(sortedCorners(other));
  }

  Agreed
  run()
  {
    for (const WideTriangle& triangle : own_.triangles)
      if (tiling_.tiles[tile_].owns(cornersInOrder(triangle).front()))
        judge(triangle);
    const std::vector<WideTriangle> own = sortedCorners(own_.triangles);
    for (const auto& other : others_)
      for (const WideTriangle& triangle : other)
        if (!std::binary_search(own.begin(), own.end(), triangle))
          agreed_.refused.push_back(triangle);
    sortUnique(agreed_.refused);
    return std::move(agreed_);
  }

private:
  void
  judge(const WideTriangle& triangle)
  {
    if (isAgreed(cornersInOrder(triangle), borderCorners(triangle, own_.points)))
      agreed_.triangles.push_back(triangle);
    else
      agreed_.refused.push_back(cornersInOrder(triangle));
  }

  /** A corner that is no border point is far from all others: with one that another
   * tile sees, it makes a triangle too long to be believed. */
  bool
  isAgreed(const WideTriangle& triangle, const Positions& corners) const
  {
    bool is_shared = false;
    for (std::size_t i = 0; i < neighbors_.size(); ++i) {
      const std::size_t seen = seenBy(tiling_.tiles[neighbors_[i]], corners);
      is_shared = is_shared || seen > 0;
      if (seen == 3 &&
          !std::binary_search(others_[i].begin(), others_[i].end(), triangle))
        return false;
    }
    if (!is_shared)
      return true;
    return corners.size() == 3 &&
           std::all_of(triangle.begin(), triangle.end(), [&](WideIndex corner) {
             const Tile& owner = tiling_.tiles[tiling_.ownerOf(corner)];
             return seenBy(owner, corners) == 3 &&
                    longestEdge(corners) <= Tile::LONGEST * owner.halo;
           });
  }

  const Tiling& tiling_;
  std::size_t tile_;
  const BorderMesh& own_;
  std::vector<std::size_t> neighbors_;
  std::vector<std::vector<WideTriangle>> others_; /**< in order, by neighbor */
  Agreed agreed_;
};

} // namespace

Agreed
agree(const Tiling& tiling,
      std::size_t tile,
      const BorderMesh& own,
      const std::vector<std::vector<WideTriangle>>& others)
{
  return Bargain(tiling, tile, own, others).run();
}

} // namespace pcl::ccaa
