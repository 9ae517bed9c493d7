// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the chains of triangles around a point.
#include <gtest/gtest.h>

#include "mesh/point_chains.h"
#include "support/shapes.h"

#include <algorithm>

namespace pcl::ccaa::test {
namespace {

/** \brief Sizes of the chains around a vertex, negative for closed ones, ascending. */
std::vector<int>
chainSizes(const Triangles& triangles,
           std::size_t vertex_count,
           pcl::index_t vertex,
           const AliveFlags* alive = nullptr)
{
  TriangleAdjacency adjacency;
  adjacency.build(triangles, vertex_count);
  PointChains chains;
  chains.find(triangles, adjacency, vertex, alive);
  std::vector<int> sizes;
  std::size_t members = 0;
  for (const auto& chain : chains.chains()) {
    EXPECT_EQ(chain.first, members);
    members += chain.size;
    const int size = static_cast<int>(chain.size);
    sizes.push_back(chain.closed ? -size : size);
  }
  EXPECT_EQ(members, chains.triangles().size());
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

TEST(PointChains, FindsOneClosedChain)
{
  const auto shape = tetrahedron();
  EXPECT_EQ(chainSizes(shape.triangles, 4, 2), std::vector<int>{-3});
}

TEST(PointChains, FindsOneOpenChain)
{
  const Triangles triangles{{0, 1, 2}, {0, 2, 3}, {3, 4, 0}};
  EXPECT_EQ(chainSizes(triangles, 5, 0), std::vector<int>{3});
  EXPECT_EQ(chainSizes(triangles, 5, 2), std::vector<int>{2});
  EXPECT_EQ(chainSizes(triangles, 5, 4), std::vector<int>{1});
}

TEST(PointChains, FindsSeveralOpenChains)
{
  EXPECT_EQ(chainSizes(bowTie().triangles, 5, 0), (std::vector<int>{1, 1}));
}

TEST(PointChains, FindsSeveralClosedChains)
{
  const auto shape = twoFansAtApex();
  const auto sizes = chainSizes(shape.triangles, shape.vertices.size(), 0);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_LT(sizes[1], 0);
}

TEST(PointChains, FindsOpenAndClosedChains)
{
  const Triangles triangles{
      {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {6, 5, 0}, {7, 0, 8}};
  EXPECT_EQ(chainSizes(triangles, 9, 0), (std::vector<int>{-3, 1, 2}));
}

TEST(PointChains, IgnoresWinding)
{
  const auto shape = icosphere(1);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto triangles = randomlyReversed(shape.triangles, seed);
    EXPECT_EQ(chainSizes(triangles, shape.vertices.size(), 0), std::vector<int>{-5});
    EXPECT_EQ(chainSizes(triangles, shape.vertices.size(), 20), std::vector<int>{-6});
  }
}

TEST(PointChains, LeavesOutDeadTriangles)
{
  const Triangles triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  AliveFlags alive{1, 0, 1, 1};
  EXPECT_EQ(chainSizes(triangles, 5, 0, &alive), std::vector<int>{3});
  alive = {1, 0, 1, 0};
  EXPECT_EQ(chainSizes(triangles, 5, 0, &alive), (std::vector<int>{1, 1}));
  alive = {0, 0, 0, 0};
  EXPECT_TRUE(chainSizes(triangles, 5, 0, &alive).empty());
}

TEST(PointChains, EndsChainsAtOverfullEdges)
{
  EXPECT_EQ(chainSizes(threeOnEdge().triangles, 5, 0), (std::vector<int>{1, 1, 1}));
}

TEST(PointChains, ListsChainsInWalkingOrder)
{
  const Triangles triangles{{0, 3, 4}, {0, 1, 2}, {4, 5, 0}, {0, 2, 3}};
  TriangleAdjacency adjacency;
  adjacency.build(triangles, 6);
  PointChains chains;
  chains.find(triangles, adjacency, 0);
  EXPECT_EQ(chains.triangles(), (std::vector<pcl::index_t>{1, 3, 0, 2}));
}

} // namespace
} // namespace pcl::ccaa::test
