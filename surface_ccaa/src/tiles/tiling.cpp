// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tiles of a cloud and what each of them sees.
#include "tiles/tiling.h"

#include <algorithm>

namespace pcl::ccaa {

namespace {

/** What lies deeper in a cell than any limit is far from all others, whatever rounding
 * does to coordinates up to 1e12 limits. */
constexpr double ROUNDING = 1.001;

} // namespace

WideTriangle
cornersInOrder(const WideTriangle& triangle)
{
  WideTriangle sorted = triangle;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double
longestEdge(const std::vector<Position>& corners)
{
  return std::max({(corners[0] - corners[1]).norm(),
                   (corners[1] - corners[2]).norm(),
                   (corners[2] - corners[0]).norm()});
}

std::size_t
Tiling::ownerOf(WideIndex point) const
{
  const auto behind = std::upper_bound(
      tiles.begin(), tiles.end(), point, [](WideIndex index, const Tile& tile) {
        return index < tile.first;
      });
  return static_cast<std::size_t>(behind - tiles.begin()) - 1;
}

std::vector<std::size_t>
Tiling::neighborsOf(std::size_t tile) const
{
  std::vector<std::size_t> neighbors;
  const Tile& own = tiles[tile];
  for (std::size_t i = 0; i < tiles.size(); ++i)
    if (i != tile &&
        own.cell.distance(tiles[i].cell) <= std::max(own.halo, tiles[i].halo))
      neighbors.push_back(i);
  return neighbors;
}

template <typename Limit>
CellsAround::CellsAround(const Tiling& tiling, std::size_t tile, const Limit& limit)
{
  double farthest = 0.0;
  for (const std::size_t i : tiling.neighborsOf(tile)) {
    boxes_.push_back(tiling.tiles[i].cell.box());
    limits_.push_back(limit(tiling.tiles[i]));
    farthest = std::max(farthest, limits_.back());
  }
  const Eigen::AlignedBox3d own = tiling.tiles[tile].cell.box();
  const Position depth = Position::Constant(ROUNDING * farthest);
  clear_ = {own.min() + depth, own.max() - depth};
}

CellsAround
CellsAround::border(const Tiling& tiling, std::size_t tile)
{
  const double own = tiling.tiles[tile].halo;
  return {tiling, tile, [own](const Tile& other) {
            return Tile::TRUSTED * other.halo +
                   Tile::AROUND * std::max(other.halo, own);
          }};
}

CellsAround
CellsAround::sight(const Tiling& tiling, std::size_t tile)
{
  return {tiling, tile, [](const Tile& other) { return Tile::TRUSTED * other.halo; }};
}

BorderPoints::const_iterator
findPoint(const BorderPoints& points, WideIndex index)
{
  const auto place = std::lower_bound(
      points.begin(), points.end(), index, [](const BorderPoint& point, WideIndex i) {
        return point.index < i;
      });
  return place == points.end() || place->index != index ? points.end() : place;
}

} // namespace pcl::ccaa
