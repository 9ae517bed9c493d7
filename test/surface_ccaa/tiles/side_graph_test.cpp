// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the outer side of surfaces that were cut into tiles.
#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "tiles/side_graph.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** \brief The number of the tile of a place. */
using TileOf = std::function<std::size_t(const Position&)>;

std::size_t
octant(const Position& p)
{
  return (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.2 ? 2 : 0) + (p.z() > -0.1 ? 4 : 0);
}

std::size_t
quarter(const Position& p)
{
  return (p.x() > 12.0 ? 1 : 0) + (p.y() > 17.0 ? 2 : 0);
}

/** What the steps of winding make of a shape whose triangles are wound at random. */
class CutShape {
public:
  CutShape(const Shape& shape,
           std::size_t tiles,
           const TileOf& tile_of,
           std::uint64_t seed,
           int threads = 1,
           const SideHints& told = {})
  : whole_(shape), triangles_(tiles), wide_(tiles), piece_of_(tiles)
  {
    for (const Triangle& triangle : randomlyReversed(shape.triangles, seed))
      triangles_[tile_of(shape.vertices[std::size_t(
                     *std::min_element(triangle.begin(), triangle.end()))])]
          .push_back(triangle);
    for (std::size_t tile = 0; tile < tiles; ++tile)
      sum(tile, threads, told);
    sides = decideSides(pieces_, true);
  }

  /** Turned as it was decided; those on torn edges are left out. */
  Triangles
  result() const
  {
    const std::set<std::array<WideIndex, 2>> torn(sides.torn.begin(), sides.torn.end());
    Triangles all;
    for (std::size_t tile = 0; tile < triangles_.size(); ++tile)
      for (std::size_t t = 0; t < triangles_[tile].size(); ++t) {
        Triangle triangle = triangles_[tile][t];
        bool is_torn = false;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto ends =
              std::minmax({WideIndex(triangle[i]), WideIndex(triangle[(i + 1) % 3])});
          is_torn = is_torn || torn.count({ends.first, ends.second}) > 0;
        }
        if (sides.turn[tile][piece_of_[tile][t]] != 0)
          std::swap(triangle[0], triangle[1]);
        if (!is_torn)
          all.push_back(triangle);
      }
    return all;
  }

  Sides sides;

private:
  /** Triangles get numbers of the tile for that, and those of the whole again. */
  void
  sum(std::size_t tile, int threads, const SideHints& told)
  {
    std::set<WideIndex> used;
    for (const Triangle& triangle : triangles_[tile])
      used.insert(triangle.begin(), triangle.end());
    std::vector<WideIndex>& wide = wide_[tile];
    wide.assign(used.begin(), used.end());
    Positions positions;
    for (const WideIndex i : wide)
      positions.push_back(whole_.vertices[i]);
    for (Triangle& triangle : triangles_[tile])
      for (index_t& corner : triangle)
        corner = index_t(std::lower_bound(wide.begin(), wide.end(), WideIndex(corner)) -
                         wide.begin());
    OrientationHints hints;
    static_cast<SideHints&>(hints) = told;
    hints.threads = threads;
    RunControl control;
    pieces_.push_back(sumUpSides(triangles_[tile],
                                 wide,
                                 positions,
                                 Position(0.3, -0.2, 0.1),
                                 hints,
                                 control,
                                 piece_of_[tile]));
    for (Triangle& triangle : triangles_[tile])
      for (index_t& corner : triangle)
        corner = index_t(wide[std::size_t(corner)]);
  }

  const Shape& whole_;
  std::vector<Triangles> triangles_;
  std::vector<std::vector<WideIndex>> wide_;
  std::vector<std::vector<std::uint32_t>> piece_of_;
  std::vector<TilePieces> pieces_;
};

TEST(SideGraph, AClosedBodyInManyTilesComesOutOutward)
{
  for (const Shape& shape : {shuffled(icosphere(3), 1), torus(30, 15), cube(6, 1.0)}) {
    const CutShape cut(shape, 8, octant, 7);
    EXPECT_TRUE(sameTriangles(shape.triangles, cut.result()));
    EXPECT_EQ(cut.sides.components, 1U);
    EXPECT_EQ(cut.sides.open_edges, 0U);
    EXPECT_TRUE(cut.sides.torn.empty());
    EXPECT_EQ(cut.sides.tally[OutwardRule::VOLUME], shape.triangles.size());
  }
}

TEST(SideGraph, IsTheSameForAnyNumberOfThreads)
{
  const Shape shape = shuffled(icosphere(4), 2);
  EXPECT_EQ(CutShape(shape, 8, octant, 3, 1).result(),
            CutShape(shape, 8, octant, 3, 3).result());
}

TEST(SideGraph, BodiesEachComeOutOutward)
{
  const Shape shape =
      joined(icosphere(3), translated(scaled(torus(20, 10), 0.3), {2.0, 0.1, 0.0}));
  const CutShape cut(shape, 8, octant, 11);
  EXPECT_TRUE(sameTriangles(shape.triangles, cut.result()));
  EXPECT_EQ(cut.sides.components, 2U);
}

TEST(SideGraph, OpenTerrainLooksUp)
{
  const Shape shape = shuffled(terrain(30, 30), 3);
  const CutShape cut(shape, 4, quarter, 5);
  EXPECT_TRUE(sameTriangles(shape.triangles, cut.result()));
  EXPECT_EQ(cut.sides.open_edges, 4U * 29);
  EXPECT_EQ(cut.sides.tally[OutwardRule::PLANE], shape.triangles.size());
}

TEST(SideGraph, ViewpointsOfAllTilesDecideTogether)
{
  // From below: against what would be guessed.
  SideHints told;
  told.told_viewpoint = Position(15.0, 15.0, -40.0);
  const Shape shape = shuffled(terrain(30, 30), 3);
  const CutShape cut(shape, 4, quarter, 6, 1, told);
  EXPECT_TRUE(sameTriangles(reversed(shape.triangles), cut.result()));
}

/** The band is opened across, and what is left can be wound alike. */
void
expectTorn(std::size_t tiles, const TileOf& tile_of)
{
  const Shape shape = moebiusBand(40);
  const CutShape cut(shape, tiles, tile_of, 9);
  EXPECT_FALSE(cut.sides.torn.empty());
  const Triangles left = cut.result();
  EXPECT_TRUE(isConsistentlyWound(left));
  EXPECT_GE(left.size() + 4, shape.triangles.size());
}

TEST(SideGraph, AMoebiusBandOfManyTilesTears) { expectTorn(8, octant); }

TEST(SideGraph, AMoebiusBandOfOneTileTears)
{
  expectTorn(1, [](const Position&) { return std::size_t{0}; });
}

/** Two pieces with edges in common, of which the first tells the other way round. */
TEST(SideGraph, WhatMostEdgesTellCounts)
{
  std::vector<TilePieces> tiles(2);
  for (std::uint32_t tile = 0; tile < 2; ++tile) {
    tiles[tile].sums.resize(1);
    for (WideIndex i = 0; i < 7; ++i)
      tiles[tile].edges.push_back({{i, i + 10}, 0, i == 0 ? 1 - tile : 1});
    tiles[tile].sums[0].open_edges = 7;
  }
  const Sides sides = decideSides(tiles, true);
  EXPECT_EQ(sides.torn, (std::vector<std::array<WideIndex, 2>>{{0, 10}}));
  EXPECT_NE(sides.turn[0][0], sides.turn[1][0]);
  EXPECT_EQ(sides.open_edges, 2U);
}

TEST(SideGraph, NoTilesAndEmptyTilesHaveNoSides)
{
  EXPECT_TRUE(decideSides({}, true).turn.empty());
  const Sides sides = decideSides(std::vector<TilePieces>(3), true);
  EXPECT_EQ(sides.turn.size(), 3U);
  EXPECT_EQ(sides.components, 0U);
}

} // namespace
} // namespace pcl::ccaa::test
