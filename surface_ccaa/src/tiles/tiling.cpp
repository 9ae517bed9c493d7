// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tiles of a cloud and what each of them sees.
#include "tiles/tiling.h"

#include <algorithm>
#include <limits>

namespace pcl::ccaa {

namespace {

/** What lies deeper in a box than any limit is far from all others, whatever rounding
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
longestEdge(const Corners& corners)
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
        (own.distance(tiles[i]) <= std::max(own.halo, tiles[i].halo) ||
         own.sparse.intersects(tiles[i].box) || tiles[i].sparse.intersects(own.box)))
      neighbors.push_back(i);
  return neighbors;
}

template <typename Limit>
TilesAround::TilesAround(const Tiling& tiling, std::size_t tile, const Limit& limit)
: clear_(Position::Constant(-std::numeric_limits<double>::infinity()),
         Position::Constant(std::numeric_limits<double>::infinity()))
{
  for (const std::size_t i : tiling.neighborsOf(tile)) {
    boxes_.push_back(tiling.tiles[i].box);
    limits_.push_back(limit(tiling.tiles[i]));
    clearOf(boxes_.back(), ROUNDING * limits_.back(), tiling.tiles[tile].box);
  }
}

/** Cut off what is not that deep beyond the side to which the other box lies. */
void
TilesAround::clearOf(const Box& other, double depth, const Box& own)
{
  Eigen::Index above = 0, below = 0;
  if ((other.min() - own.max()).maxCoeff(&above) >=
      (own.min() - other.max()).maxCoeff(&below))
    clear_.max()[above] = std::min(clear_.max()[above], other.min()[above] - depth);
  else
    clear_.min()[below] = std::max(clear_.min()[below], other.max()[below] + depth);
}

TilesAround
TilesAround::border(const Tiling& tiling, std::size_t tile)
{
  const double own = tiling.tiles[tile].halo;
  return {tiling, tile, [own](const Tile& other) {
            return Tile::TRUSTED * other.halo + Tile::TOLD * std::max(other.halo, own);
          }};
}

TilesAround
TilesAround::sight(const Tiling& tiling, std::size_t tile)
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
