// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a rough sheet in tiles whose meshes differ.

#pragma once

#include "mesh/box_tree.h"
#include "support/random_source.h"
#include "tiles/agreement.h"
#include "tiles/world_grid.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

/** Points of a rough sheet over 3 * 3 tiles of side 16, at a spacing of about 1, and a
 * mesh of it for each tile, which differ here and there. */
class Patchwork {
public:
  /** \param[in] unlike share of what a tile makes differently
   * \param[in] halo the smallest: below 14 the longest edges are too long for it
   * \param[in] sparse share of points with a halo of their own */
  Patchwork(std::uint64_t seed, double unlike, double halo = 9.0, double sparse = 0.0)
  : random_(seed)
  {
    std::vector<std::pair<GridCell, std::size_t>> by_cell;
    Positions places;
    for (std::size_t i = 0; i < SIDE * SIDE; ++i) {
      places.emplace_back(double(i % SIDE) + random_.uniform(0.1, 0.9),
                          double(i / SIDE) + random_.uniform(0.1, 0.9),
                          random_.uniform(0.0, 0.4));
      by_cell.emplace_back(cellOf(places.back(), 4), i);
    }
    std::sort(by_cell.begin(), by_cell.end());
    std::vector<WideIndex> index_of(places.size());
    for (std::size_t i = 0; i < by_cell.size(); ++i) {
      if (i == 0 || !(by_cell[i].first == by_cell[i - 1].first)) {
        tiling.tiles.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto k = static_cast<Eigen::Index>(axis);
          tiling.tiles.back().box.min()[k] = 16.0 * double(by_cell[i].first.at[axis]);
          tiling.tiles.back().box.max()[k] = tiling.tiles.back().box.min()[k] + 16.0;
        }
        tiling.tiles.back().first = i;
        tiling.tiles.back().halo = halo + random_.uniform(0.0, 7.0);
      }
      ++tiling.tiles.back().count;
      points.push_back(places[by_cell[i].second]);
      index_of[by_cell[i].second] = i;
    }
    giveHalos(seed, sparse);
    for (std::size_t tile = 0; tile < tiling.tiles.size(); ++tile)
      meshes.push_back(meshOf(tile, index_of, unlike));
  }

  Tiling tiling;
  Positions points;                              /**< by index */
  std::vector<double> halos;                     /**< their own, 0: none */
  std::vector<std::vector<WideTriangle>> meshes; /**< by tile */

  /** As a tile tells it to others. */
  BorderMesh
  borderOf(std::size_t tile) const
  {
    const TilesAround others = TilesAround::border(tiling, tile);
    const Tile& own = tiling.tiles[tile];
    BorderMesh border;
    std::set<WideIndex> near, told;
    for (WideIndex i = 0; i < points.size(); ++i)
      if (own.knows(points[i], halos[i]) && others.isNear(points[i], halos[i]))
        near.insert(i);
    for (const WideTriangle& triangle : meshes[tile])
      if (std::any_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
            return near.count(i) > 0 || tiling.ownerOf(i) != tile;
          })) {
        border.triangles.push_back(triangle);
        told.insert(triangle.begin(), triangle.end());
      }
    told.insert(near.begin(), near.end());
    for (const WideIndex i : told)
      border.points.push_back({i, points[i], halos[i]});
    return border;
  }

  std::vector<std::vector<WideTriangle>>
  told(std::size_t tile) const
  {
    std::vector<std::vector<WideTriangle>> others;
    for (const std::size_t other : tiling.neighborsOf(tile)) {
      others.emplace_back();
      for (const WideTriangle& triangle : borderOf(other).triangles)
        if (tiling.ownerOf(cornersInOrder(triangle)[0]) == tile)
          others.back().push_back(triangle);
    }
    return others;
  }

  bool
  sees(std::size_t tile, WideIndex point) const
  {
    return tiling.tiles[tile].sees(points[point], halos[point]);
  }

private:
  static constexpr std::size_t SIDE = 48;

  void
  giveHalos(std::uint64_t seed, double sparse)
  {
    RandomSource random(1000 + seed);
    for (WideIndex i = 0; i < points.size(); ++i) {
      Tile& owner = tiling.tiles[tiling.ownerOf(i)];
      const bool is_sparse = random.uniform() < sparse;
      halos.push_back(is_sparse ? random.uniform(1.5, 3.5) * owner.halo : 0.0);
      if (is_sparse)
        owner.sparse.extend(widened(Box(points[i]), halos.back()));
    }
  }

  std::vector<WideTriangle>
  meshOf(std::size_t tile, const std::vector<WideIndex>& index_of, double unlike)
  {
    std::vector<WideTriangle> mesh;
    for (std::size_t i = 0; i + SIDE < SIDE * SIDE; ++i) {
      if (i % SIDE + 1 == SIDE)
        continue;
      const std::array<WideIndex, 4> c{
          index_of[i], index_of[i + 1], index_of[i + SIDE + 1], index_of[i + SIDE]};
      const bool is_flipped = random_.uniform() < unlike;
      for (const WideTriangle& triangle :
           is_flipped
               ? std::array<WideTriangle, 2>{{{c[0], c[1], c[3]}, {c[1], c[2], c[3]}}}
               : std::array<WideTriangle, 2>{{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}})
        if (random_.uniform() >= unlike &&
            std::all_of(triangle.begin(), triangle.end(), [&](WideIndex corner) {
              return sees(tile, corner);
            }))
          mesh.push_back(turnedAtRandom(triangle));
    }
    return mesh;
  }

  WideTriangle
  turnedAtRandom(WideTriangle triangle)
  {
    std::rotate(triangle.begin(),
                triangle.begin() + static_cast<std::ptrdiff_t>(random_.below(3)),
                triangle.end());
    if (random_.below(2) == 0)
      std::swap(triangle[0], triangle[1]);
    return triangle;
  }

  RandomSource random_;
};

} // namespace pcl::ccaa::test
