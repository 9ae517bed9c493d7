// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the one-dimensional grid of lengths.
#include <gtest/gtest.h>

#include "greedy/length_buckets.h"

#include <algorithm>
#include <random>

using pcl::ccaa::CandidateEdge;
using pcl::ccaa::LengthBuckets;

namespace {

std::vector<CandidateEdge>
randomEdges(std::size_t count, float shortest, float longest)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> length(shortest, longest);
  std::vector<CandidateEdge> edges;
  for (std::size_t i = 0; i < count; ++i)
    edges.push_back({pcl::index_t(i), pcl::index_t(i + 1), length(random)});
  return edges;
}

float
largestStepBack(const std::vector<CandidateEdge>& edges)
{
  float longest = 0, step = 0;
  for (const CandidateEdge& edge : edges) {
    step = std::max(step, longest - edge.length);
    longest = std::max(longest, edge.length);
  }
  return step;
}

TEST(LengthBuckets, OrdersLengthsUpToTheWidthOfACell)
{
  std::vector<CandidateEdge> edges = randomEdges(5000, 2.0f, 6.0f);
  LengthBuckets().sort(edges);
  EXPECT_LE(largestStepBack(edges), 4.0f / LengthBuckets::CELLS * 1.01f);
}

TEST(LengthBuckets, KeepsEveryEdge)
{
  std::vector<CandidateEdge> edges = randomEdges(3000, 0.1f, 1.0f);
  LengthBuckets().sort(edges);
  std::vector<pcl::index_t> seen;
  for (const CandidateEdge& edge : edges)
    seen.push_back(edge.a);
  std::sort(seen.begin(), seen.end());
  for (std::size_t i = 0; i < seen.size(); ++i)
    ASSERT_EQ(seen[i], pcl::index_t(i));
}

TEST(LengthBuckets, KeepsTheOrderOfEqualLengths)
{
  std::vector<CandidateEdge> edges = randomEdges(100, 1.0f, 1.0f);
  LengthBuckets().sort(edges);
  for (std::size_t i = 0; i < edges.size(); ++i)
    ASSERT_EQ(edges[i].a, pcl::index_t(i));
}

TEST(LengthBuckets, OrdersLengthsOfVeryDifferentMagnitude)
{
  std::vector<CandidateEdge> edges = {{0, 1, 1e30f}, {1, 2, 1e-30f}, {2, 3, 5e29f}};
  LengthBuckets().sort(edges);
  EXPECT_EQ(edges[0].a, 1);
  EXPECT_EQ(edges[1].a, 2);
  EXPECT_EQ(edges[2].a, 0);
}

TEST(LengthBuckets, TakesAnEmptyList)
{
  std::vector<CandidateEdge> edges;
  LengthBuckets().sort(edges);
  EXPECT_TRUE(edges.empty());
}

} // namespace
