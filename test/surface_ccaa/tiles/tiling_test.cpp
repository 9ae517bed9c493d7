// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which tiles know what.

#include <gtest/gtest.h>

#include "patchwork.h"

namespace pcl::ccaa::test {
namespace {

TEST(Tiling, KnowsTheOwnerOfEachPointAndTheTilesAround)
{
  const Patchwork patchwork(40, 0.0);
  const Tiling& tiling = patchwork.tiling;
  ASSERT_EQ(tiling.tiles.size(), 9U);
  for (WideIndex i = 0; i < patchwork.points.size(); ++i)
    ASSERT_EQ(tiling.tiles[tiling.ownerOf(i)].distance(patchwork.points[i]), 0.0);
  for (std::size_t tile = 0; tile < 9; ++tile) {
    std::vector<std::size_t> expected;
    for (std::size_t other = 0; other < 9; ++other)
      if (other != tile &&
          tiling.tiles[tile].distance(tiling.tiles[other]) <=
              std::max(tiling.tiles[tile].halo, tiling.tiles[other].halo))
        expected.push_back(other);
    EXPECT_EQ(tiling.neighborsOf(tile), expected);
    for (const std::size_t other : expected) {
      const auto back = tiling.neighborsOf(other);
      EXPECT_EQ(1, std::count(back.begin(), back.end(), tile));
    }
  }
}

TEST(Tiling, WhoKnowsASparsePointIsANeighbor)
{
  const Patchwork patchwork(41, 0.0, 9.0, 0.02);
  std::size_t far = 0;
  for (WideIndex i = 0; i < patchwork.points.size(); ++i) {
    const std::size_t owner = patchwork.tiling.ownerOf(i);
    const auto neighbors = patchwork.tiling.neighborsOf(owner);
    for (std::size_t tile = 0; tile < patchwork.tiling.tiles.size(); ++tile) {
      const Tile& other = patchwork.tiling.tiles[tile];
      if (tile == owner || !other.knows(patchwork.points[i], patchwork.halos[i]))
        continue;
      far += other.knows(patchwork.points[i], 0.0) ? 0 : 1;
      ASSERT_EQ(1, std::count(neighbors.begin(), neighbors.end(), tile));
    }
  }
  EXPECT_GT(far, 10U);
}

TEST(Tile, IsAsFarAsItsBoxAlongTheFarthestAxis)
{
  RandomSource random(4);
  const auto place = [&] {
    return Position(random.uniform(-9.0, 9.0),
                    random.uniform(-9.0, 9.0),
                    random.uniform(-9.0, 9.0));
  };
  for (int round = 0; round < 500; ++round) {
    Tile one, other;
    one.box.extend(place()).extend(place());
    other.box.extend(place()).extend(place());
    const Position position = place();
    double to_place = 0.0, to_other = 0.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double low = one.box.min()[axis], high = one.box.max()[axis];
      to_place = std::max({to_place, low - position[axis], position[axis] - high});
      to_other = std::max(
          {to_other, low - other.box.max()[axis], other.box.min()[axis] - high});
    }
    ASSERT_EQ(one.distance(position), to_place);
    ASSERT_EQ(one.distance(other), to_other);
    ASSERT_EQ(other.distance(one), to_other);
  }
}

TEST(TilesAround, AreThoseWhoseDistanceIsWithinTheirLimit)
{
  std::size_t near = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Patchwork patchwork(seed, 0.05, 9.0, 0.1);
    const Tiling& tiling = patchwork.tiling;
    for (std::size_t tile = 0; tile < tiling.tiles.size(); ++tile) {
      const std::vector<std::size_t> neighbors = tiling.neighborsOf(tile);
      const double halo = tiling.tiles[tile].halo;
      const TilesAround border = TilesAround::border(tiling, tile);
      const TilesAround sight = TilesAround::sight(tiling, tile);
      for (WideIndex p = 0; p < patchwork.points.size(); ++p) {
        const Position& point = patchwork.points[p];
        const double own_halo = patchwork.halos[p];
        std::vector<std::size_t> seers, expected;
        sight.forEachNear(point, own_halo, [&](std::size_t i) { seers.push_back(i); });
        bool is_border = false;
        for (std::size_t i = 0; i < neighbors.size(); ++i) {
          const Tile& other = tiling.tiles[neighbors[i]];
          if (other.sees(point, own_halo))
            expected.push_back(i);
          is_border =
              is_border || other.sees(point, own_halo) ||
              other.distance(point) <=
                  Tile::TRUSTED * other.halo + Tile::TOLD * std::max(other.halo, halo);
        }
        ASSERT_EQ(expected, seers);
        ASSERT_EQ(is_border, border.isNear(point, own_halo));
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
            return tiling.tiles[other].sees(patchwork.points[i], 0.0);
          }))
        continue;
      for (WideIndex j = 0; j < patchwork.points.size(); ++j) {
        if ((patchwork.points[i] - patchwork.points[j]).norm() > Tile::TOLD * halo)
          continue;
        ++around;
        const std::size_t owner = tiling.ownerOf(j);
        EXPECT_TRUE(
            TilesAround::border(tiling, owner).isNear(patchwork.points[j], 0.0));
      }
    }
  }
  EXPECT_GT(around, 1000U);
}

} // namespace
} // namespace pcl::ccaa::test
