// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which islands a mesh has.
#include <gtest/gtest.h>

#include "mesh/islands.h"
#include "support/completion_shapes.h"
#include "support/shapes.h"

namespace pcl::ccaa::test {
namespace {

std::vector<std::size_t>
islandsOf(const Shape& shape)
{
  const Islands islands = labelIslands(adjacencyOf(shape));
  std::vector<std::size_t> labels;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    labels.push_back(islands[t]);
  return labels;
}

TEST(Islands, AreThePiecesThatEdgesConnect)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const double share = 0.05 * static_cast<double>(seed + 1);
    const Shape shape =
        shuffled(withoutRandomTriangles(icosphere(3), share, seed), seed);
    EXPECT_EQ(islandsOf(shape), pieceOfTriangles(shape.triangles)) << seed;
  }
}

TEST(Islands, AreNotConnectedByAnEdgeWithThreeTriangles)
{
  EXPECT_EQ(islandsOf(threeOnEdge()), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Islands, AreNotConnectedByAPoint)
{
  EXPECT_EQ(islandsOf(bowTie()), (std::vector<std::size_t>{0, 1}));
}

TEST(Islands, AreNotConnectedByTrianglesThatAreToBeAlone)
{
  const Shape strip = grid(4, 2); // of the second square one triangle leads on
  const Islands parts = labelIslands(adjacencyOf(strip), {}, {2});
  EXPECT_EQ(parts.of_triangle, (std::vector<index_t>{0, 0, 1, 0, 2, 2}));
}

TEST(Islands, OfNothingAreNone)
{
  EXPECT_EQ(labelIslands(TriangleAdjacency{}).count, 0u);
}

} // namespace
} // namespace pcl::ccaa::test
