// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#include <gtest/gtest.h>

#include "mesh/thin_necks.h"
#include "support/shapes.h"

#include <algorithm>

namespace pcl::ccaa::test {
namespace {

/** Their vertices. */
std::vector<pcl::index_t>
necksOf(const Shape& shape, int threads = 1)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  const LoopContext context{threads, nullptr, "", 64};
  std::vector<pcl::index_t> vertices;
  for (const ThinNeck& neck :
       thinNecks(shape.triangles, adjacency, PointView(shape.vertices), context))
    vertices.push_back(neck.vertex);
  return vertices;
}

TEST(ThinNecks, ARingBetweenTwoSpheresIsOne)
{
  EXPECT_EQ(1U, necksOf(spheresJoinedByTube(0.1, 1)).size());
}

TEST(ThinNecks, EachIsToldOnce)
{
  const Shape pair = spheresJoinedByTube(0.1, 1);
  EXPECT_EQ(2U, necksOf(joined(pair, translated(pair, {0.0, 5.0, 0.0}))).size());
}

TEST(ThinNecks, ALongTubeIsNone)
{
  EXPECT_TRUE(necksOf(spheresJoinedByTube(2.0, 12)).empty());
}

TEST(ThinNecks, BodiesWithoutANeckHaveNone)
{
  EXPECT_TRUE(necksOf(icosphere(3)).empty());
  EXPECT_TRUE(necksOf(torus(40, 20)).empty());
  EXPECT_TRUE(necksOf(torus(60, 6)).empty());
}

TEST(ThinNecks, NothingIsToldBesideABoundary)
{
  Shape pair = spheresJoinedByTube(0.1, 1);
  const auto at_neck = std::find_if(
      pair.triangles.begin(), pair.triangles.end(), [&](const Triangle& triangle) {
        const auto half = static_cast<pcl::index_t>(pair.vertices.size() / 2);
        return triangle[0] < half && triangle[1] >= half;
      });
  ASSERT_NE(pair.triangles.end(), at_neck);
  pair.triangles.erase(at_neck);
  EXPECT_TRUE(necksOf(pair).empty());
}

TEST(ThinNecks, AreTheSameForAnyNumberOfThreads)
{
  const Shape pair = spheresJoinedByTube(0.1, 1);
  EXPECT_EQ(necksOf(pair), necksOf(pair, 4));
}

} // namespace
} // namespace pcl::ccaa::test
