// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles make alike stays, against a slow twin that knows
// all tiles.
#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/random_source.h"
#include "tiles/agreement.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** Points of a rough sheet over 3 * 3 tiles of side 16, at a spacing of about 1, and a
 * mesh of it for each tile, which differ here and there. */
class Patchwork {
public:
  /** \param[in] unlike share of what a tile makes differently
   * \param[in] halo the smallest: below 14 the longest edges are too long for it */
  Patchwork(std::uint64_t seed, double unlike, double halo = 9.0) : random_(seed)
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
        tiling.tiles.back().cell = by_cell[i].first;
        tiling.tiles.back().first = i;
        tiling.tiles.back().halo = halo + random_.uniform(0.0, 7.0);
      }
      ++tiling.tiles.back().count;
      points.push_back(places[by_cell[i].second]);
      index_of[by_cell[i].second] = i;
    }
    for (std::size_t tile = 0; tile < tiling.tiles.size(); ++tile)
      meshes.push_back(meshOf(tile, index_of, unlike));
  }

  Tiling tiling;
  Positions points;                              /**< by index */
  std::vector<std::vector<WideTriangle>> meshes; /**< by tile */

  /** As a tile tells it to others. */
  BorderMesh
  borderOf(std::size_t tile) const
  {
    const CellsAround others = CellsAround::border(tiling, tile);
    const Tile& own = tiling.tiles[tile];
    BorderMesh border;
    std::set<WideIndex> near;
    for (WideIndex i = 0; i < points.size(); ++i)
      if (own.cell.distance(points[i]) <= own.halo && others.isNear(points[i])) {
        border.points.push_back({i, points[i]});
        near.insert(i);
      }
    for (const WideTriangle& triangle : meshes[tile])
      if (std::any_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
            return near.count(i) > 0 || tiling.ownerOf(i) != tile;
          }))
        border.triangles.push_back(triangle);
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
    return tiling.tiles[tile].sees(points[point]);
  }

private:
  static constexpr std::size_t SIDE = 48;

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

/** Everything is looked at, and every tile. */
class Twin {
public:
  explicit Twin(const Patchwork& patchwork) : all_(patchwork)
  {
    for (const auto& mesh : patchwork.meshes) {
      sets_.emplace_back();
      for (const WideTriangle& triangle : mesh)
        sets_.back().insert(cornersInOrder(triangle));
    }
  }

  bool
  stays(const WideTriangle& triangle) const
  {
    const auto seesAny = [&](std::size_t tile) {
      return std::any_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
        return all_.sees(tile, i);
      });
    };
    const std::size_t own = all_.tiling.ownerOf(triangle[0]);
    bool is_shared = false;
    for (std::size_t tile = 0; tile < sets_.size(); ++tile) {
      is_shared = is_shared || (tile != own && seesAny(tile));
      if ((tile == own || seesAll(tile, triangle)) && !has(tile, triangle))
        return false;
    }
    return !is_shared ||
           std::all_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
             const std::size_t owner = all_.tiling.ownerOf(i);
             return seesAll(owner, triangle) &&
                    longest(triangle) <= 0.2 * all_.tiling.tiles[owner].halo;
           });
  }

  /** All triangles of which a tile has the lowest corner, of any mesh. */
  std::set<WideTriangle>
  candidates(std::size_t tile) const
  {
    std::set<WideTriangle> found;
    for (const auto& set : sets_)
      for (const WideTriangle& triangle : set)
        if (all_.tiling.ownerOf(triangle[0]) == tile)
          found.insert(triangle);
    return found;
  }

private:
  bool
  has(std::size_t tile, const WideTriangle& triangle) const
  {
    return sets_[tile].count(triangle) > 0;
  }
  bool
  seesAll(std::size_t tile, const WideTriangle& triangle) const
  {
    return std::all_of(triangle.begin(), triangle.end(), [&](WideIndex i) {
      return all_.sees(tile, i);
    });
  }
  double
  longest(const WideTriangle& t) const
  {
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      length =
          std::max(length, (all_.points[t[i]] - all_.points[t[(i + 1) % 3]]).norm());
    return length;
  }

  const Patchwork& all_;
  std::vector<std::set<WideTriangle>> sets_;
};

/** Inner triangles of a tile stay without being asked. */
std::vector<WideTriangle>
keptOf(const Patchwork& patchwork, std::size_t tile, Agreed& agreed)
{
  const BorderMesh border = patchwork.borderOf(tile);
  agreed = agree(patchwork.tiling, tile, border, patchwork.told(tile));
  std::vector<WideTriangle> kept = agreed.triangles;
  const std::set<WideTriangle> asked(border.triangles.begin(), border.triangles.end());
  for (const WideTriangle& triangle : patchwork.meshes[tile])
    if (asked.count(triangle) == 0)
      kept.push_back(triangle);
  return kept;
}

TEST(Agreement, KeepsWhatTheTwinKeepsAndTellsTheRest)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Patchwork patchwork(seed, 0.02 * double(seed - 1));
    const Twin twin(patchwork);
    for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
      Agreed agreed;
      std::set<WideTriangle> kept, expected;
      for (const WideTriangle& triangle : keptOf(patchwork, tile, agreed))
        EXPECT_TRUE(kept.insert(cornersInOrder(triangle)).second);
      std::set<WideTriangle> refused;
      for (const WideTriangle& triangle : twin.candidates(tile))
        if (twin.stays(triangle))
          expected.insert(triangle);
        else
          refused.insert(cornersInOrder(triangle));
      EXPECT_TRUE(kept == expected) << seed << ", tile " << tile;
      EXPECT_EQ(std::vector<WideTriangle>(refused.begin(), refused.end()),
                agreed.refused);
    }
  }
}

TEST(Agreement, WhatStaysHasNoEdgeWithThreeTriangles)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Patchwork patchwork(seed + 10, 0.05);
    std::map<std::pair<WideIndex, WideIndex>, int> uses;
    for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
      Agreed agreed;
      for (const WideTriangle& t : keptOf(patchwork, tile, agreed))
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_LE(++uses[std::minmax(t[i], t[(i + 1) % 3])], 2);
    }
    EXPECT_GT(uses.size(), 3000U);
  }
}

TEST(Agreement, TilesThatMakeTheSameKeepEverything)
{
  const Patchwork patchwork(30, 0.0, 14.0);
  std::size_t kept = 0;
  for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
    Agreed agreed;
    kept += keptOf(patchwork, tile, agreed).size();
    EXPECT_TRUE(agreed.refused.empty());
  }
  EXPECT_EQ(kept, 2U * 47 * 47);
}

TEST(Agreement, ATileThatIsAloneKeepsAll)
{
  Tiling tiling;
  tiling.tiles.emplace_back();
  tiling.tiles.back().count = 4;
  BorderMesh own;
  own.triangles = {{0, 1, 2}, {3, 2, 1}};
  const Agreed agreed = agree(tiling, 0, own, {});
  EXPECT_EQ(agreed.triangles, own.triangles);
  EXPECT_TRUE(agreed.refused.empty());
}

TEST(Tiling, KnowsTheOwnerOfEachPointAndTheTilesAround)
{
  const Patchwork patchwork(40, 0.0);
  const Tiling& tiling = patchwork.tiling;
  ASSERT_EQ(tiling.tiles.size(), 9U);
  for (WideIndex i = 0; i < patchwork.points.size(); ++i)
    ASSERT_EQ(tiling.tiles[tiling.ownerOf(i)].cell.distance(patchwork.points[i]), 0.0);
  for (std::size_t tile = 0; tile < 9; ++tile) {
    std::vector<std::size_t> expected;
    for (std::size_t other = 0; other < 9; ++other)
      if (other != tile &&
          tiling.tiles[tile].cell.distance(tiling.tiles[other].cell) <=
              std::max(tiling.tiles[tile].halo, tiling.tiles[other].halo))
        expected.push_back(other);
    EXPECT_EQ(tiling.neighborsOf(tile), expected);
    for (const std::size_t other : expected) {
      const auto back = tiling.neighborsOf(other);
      EXPECT_EQ(1, std::count(back.begin(), back.end(), tile));
    }
  }
}

TEST(CellsAround, AreThoseWhoseDistanceIsWithinTheirLimit)
{
  std::size_t near = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Patchwork patchwork(seed, 0.05);
    const Tiling& tiling = patchwork.tiling;
    for (std::size_t tile = 0; tile < tiling.tiles.size(); ++tile) {
      const std::vector<std::size_t> neighbors = tiling.neighborsOf(tile);
      const double halo = tiling.tiles[tile].halo;
      const CellsAround border = CellsAround::border(tiling, tile);
      const CellsAround sight = CellsAround::sight(tiling, tile);
      for (const Position& point : patchwork.points) {
        std::vector<std::size_t> seers, expected;
        sight.forEachNear(point, [&](std::size_t i) { seers.push_back(i); });
        bool is_border = false;
        for (std::size_t i = 0; i < neighbors.size(); ++i) {
          const Tile& other = tiling.tiles[neighbors[i]];
          if (other.sees(point))
            expected.push_back(i);
          is_border = is_border || other.cell.distance(point) <=
                                       Tile::TRUSTED * other.halo +
                                           Tile::AROUND * std::max(other.halo, halo);
        }
        ASSERT_EQ(expected, seers);
        ASSERT_EQ(is_border, border.isNear(point));
        near += expected.size();
      }
    }
  }
  EXPECT_GT(near, 1000U);
}

TEST(Tiling, TellsOthersWhatLiesAroundWhatTheyDisagreeAbout)
{
  std::size_t around = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Patchwork patchwork(seed, 0.0);
    const Tiling& tiling = patchwork.tiling;
    for (WideIndex i = 0; i < patchwork.points.size(); i += 7) {
      const std::size_t tile = tiling.ownerOf(i);
      const auto neighbors = tiling.neighborsOf(tile);
      const double halo = tiling.tiles[tile].halo;
      if (std::none_of(neighbors.begin(), neighbors.end(), [&](std::size_t other) {
            return tiling.tiles[other].sees(patchwork.points[i]);
          }))
        continue;
      for (WideIndex j = 0; j < patchwork.points.size(); ++j) {
        if ((patchwork.points[i] - patchwork.points[j]).norm() > Tile::AROUND * halo)
          continue;
        ++around;
        const std::size_t owner = tiling.ownerOf(j);
        EXPECT_TRUE(CellsAround::border(tiling, owner).isNear(patchwork.points[j]));
      }
    }
  }
  EXPECT_GT(around, 1000U);
}

} // namespace
} // namespace pcl::ccaa::test
