// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tiles of a cloud and what each of them sees.
#include "tiles/tiling.h"

#include <algorithm>

namespace pcl::ccaa {

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

bool
Tiling::isNearOthers(const Position& position,
                     std::size_t tile,
                     const std::vector<std::size_t>& neighbors) const
{
  return std::any_of(neighbors.begin(), neighbors.end(), [&](std::size_t i) {
    const double halo = tiles[i].halo;
    return tiles[i].cell.distance(position) <=
           Tile::TRUSTED * halo + Tile::AROUND * std::max(halo, tiles[tile].halo);
  });
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
