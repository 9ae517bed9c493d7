// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: boundary loops of many tiles and their clusters.
#include <gtest/gtest.h>

#include "tiles/open_loops.h"

#include <cmath>
#include <map>

namespace pcl::ccaa {
namespace {

/** Loops as regular polygons in the plane z = 0, one behind the other in one tile. */
struct Scene {
  std::vector<OpenEdge> edges;
  std::vector<WideIndex> points;
  std::vector<Position> positions;
  std::vector<SideSums> components = std::vector<SideSums>(1);
  Tiling tiling;

  Scene()
  {
    addTile();
    components[0].area = 1.0;
  }

  void
  addTile()
  {
    tiling.tiles.emplace_back();
    tiling.tiles.back().halo = 100.0 * Tile::SPACINGS;
  }

  void
  addLoop(double x, double y, double radius, std::size_t corners)
  {
    const WideIndex first = points.size();
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 2.0 * M_PI * double(i) / double(corners);
      points.push_back(first + i);
      positions.emplace_back(
          x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0);
      const WideIndex next = first + (i + 1) % corners;
      edges.push_back({{std::min(first + i, next), std::max(first + i, next)}, 0});
    }
    tiling.tiles.back().count = points.size();
  }

  std::vector<OpenLoop>
  cluster(std::uint64_t most_points)
  {
    // A sheet in which four points lie in each unit of area.
    const auto points_in = [](const Box& box) {
      return static_cast<std::uint64_t>(4.0 * box.sizes().x() * box.sizes().y());
    };
    return clusterLoops(
        edges, points, positions, components, tiling, points_in, most_points);
  }
};

TEST(OpenLoops, LoopsFarApartAreClustersOfTheirOwn)
{
  Scene scene;
  for (int i = 0; i < 5; ++i)
    scene.addLoop(100.0 * i, 0, 1, 8);
  const auto loops = scene.cluster(10000);
  ASSERT_EQ(5U, loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_EQ(LoopUse::REPAIR, loops[i].use);
    EXPECT_EQ(i, loops[i].cluster);
    EXPECT_EQ(8U, loops[i].end - loops[i].begin);
  }
}

TEST(OpenLoops, NearLoopsAreOneClusterAsFarAsItFits)
{
  Scene scene;
  scene.addLoop(0, 0, 1, 8);
  scene.addLoop(7, 0, 1, 8);
  EXPECT_EQ(0U, scene.cluster(10000)[1].cluster);
  const auto loops = scene.cluster(scene.cluster(10000)[0].points * 3 / 2);
  EXPECT_EQ(LoopUse::REPAIR, loops[1].use);
  EXPECT_EQ(1U, loops[1].cluster);
}

TEST(OpenLoops, TheNearestOfThreeAreTogetherWhereAllAreTooMany)
{
  Scene scene;
  scene.addLoop(0, 0, 1, 8);
  scene.addLoop(8, 0, 1, 8);
  scene.addLoop(15, 0, 1, 8);
  const auto loops = scene.cluster(scene.cluster(10000)[0].points * 5 / 2);
  EXPECT_EQ(0U, loops[0].cluster);
  EXPECT_EQ(1U, loops[1].cluster);
  EXPECT_EQ(1U, loops[2].cluster);
}

TEST(OpenLoops, OneThatHoldsMoreThanATileIsBeyondIt)
{
  Scene scene;
  scene.addLoop(0, 0, 100, 400);
  scene.addLoop(1000, 0, 1, 8);
  const auto loops = scene.cluster(1000);
  EXPECT_EQ(LoopUse::BEYOND, loops[0].use);
  EXPECT_EQ(LoopUse::REPAIR, loops[1].use);
  EXPECT_EQ(0U, loops[1].cluster);
}

TEST(OpenLoops, TheLargeLoopAroundASheetIsItsBorder)
{
  Scene scene;
  scene.addLoop(0, 0, 100, 400);
  scene.components[0].box = Box(Position(-100, -100, -3), Position(100, 100, 3));
  scene.components[0].normals = Position(0, 0, 0.9);
  EXPECT_EQ(LoopUse::BORDER, scene.cluster(1000)[0].use);
  scene.components[0].normals = Position(0, 0, 0.4); // that of a body
  EXPECT_EQ(LoopUse::BEYOND, scene.cluster(1000)[0].use);
  scene.components[0].normals = Position(0, 0, 0.9);
  scene.components[0].box = Box(Position(-100, -200, -3), Position(100, 200, 3));
  EXPECT_EQ(LoopUse::BEYOND, scene.cluster(1000)[0].use);
}

TEST(OpenLoops, ChainsAreCutIntoClustersThatFit)
{
  Scene scene;
  for (int i = 0; i < 40; ++i)
    scene.addLoop(3.1 * (i % 8), 4.3 * (i / 8), 0.5 + 0.05 * (i % 7), 9);
  for (const std::uint64_t most : {500U, 1000U, 3000U}) {
    std::map<std::uint64_t, std::uint64_t> points;
    for (const OpenLoop& loop : scene.cluster(most)) {
      EXPECT_EQ(LoopUse::REPAIR, loop.use);
      points[loop.cluster] += loop.points;
    }
    for (const auto& [cluster, sum] : points)
      EXPECT_LE(sum, most);
    EXPECT_GT(points.size(), 1U);
  }
}

TEST(OpenLoops, LongEdgesDoNotWidenTheRegionBeyondTheSpacing)
{
  Scene scene;
  scene.addLoop(0, 0, 1, 4);
  scene.tiling.tiles[0].halo = 0.1 * Tile::SPACINGS;
  EXPECT_NEAR(
      2.0 + std::sqrt(8.0) + 0.8, scene.cluster(1000)[0].region().sizes().x(), 1e-9);
}

TEST(OpenLoops, EdgesThatTwoTilesHaveAreNotOpen)
{
  std::vector<TilePieces> tiles(2);
  for (TilePieces& tile : tiles)
    tile.sums.resize(1);
  tiles[0].edges = {{{1, 2}, 0, 0}, {{2, 3}, 0, 0}};
  tiles[1].edges = {{{1, 2}, 0, 1}, {{5, 9}, 0, 0}};
  const auto edges = openEdges(tiles, decideSides(tiles, false));
  ASSERT_EQ(2U, edges.size());
  EXPECT_EQ((std::array<WideIndex, 2>{2, 3}), edges[0].ends);
  EXPECT_EQ((std::array<WideIndex, 2>{5, 9}), edges[1].ends);
  EXPECT_EQ(edges[0].component, edges[1].component);
}

TEST(OpenLoops, NoEdgesMakeNoLoops) { EXPECT_TRUE(Scene().cluster(1000).empty()); }

} // namespace
} // namespace pcl::ccaa
