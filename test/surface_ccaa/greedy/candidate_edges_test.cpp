// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which edges are tried, and in whose charge.
#include <gtest/gtest.h>

#include "greedy/candidate_edges.h"
#include "ranked_cloud.h"
#include "support/clouds.h"

#include <map>
#include <utility>

namespace pcl::ccaa::test {
namespace {

using Edge = std::pair<index_t, index_t>;

/** Points, their neighbors and their votes. */
class CandidateEdgesTest : public ::testing::Test {
protected:
  void
  setPoints(const Positions& positions, unsigned int k, float reach)
  {
    cloud_ = std::make_unique<RankedCloud>(positions, k);
    votes_.assign(positions.size(), {});
    certifyEdges(
        cloud_->points(), cloud_->rows(), reach, 0, positions.size(), votes_.data());
  }

  std::map<Edge, int>
  certified() const
  {
    return collect([](const CandidateEdges& edges, index_t a, const auto& use) {
      edges.forCertified(a, use);
    });
  }

  std::map<Edge, int>
  plain() const
  {
    return collect([](const CandidateEdges& edges, index_t a, const auto& use) {
      edges.forPlain(
          a, [](index_t) { return true; }, use);
    });
  }

  /** How often each edge comes. */
  template <typename Walk>
  std::map<Edge, int>
  collect(Walk walk) const
  {
    const NeighborRows rows = cloud_->rows();
    const CandidateEdges edges(cloud_->points(), rows, votes_);
    std::map<Edge, int> found;
    for (std::size_t a = 0; a < votes_.size(); ++a)
      walk(edges, index_t(a), [&](const CandidateEdge& edge, EdgeStanding) {
        ++found[std::minmax(edge.a, edge.b)];
      });
    return found;
  }

  std::unique_ptr<RankedCloud> cloud_;
  std::vector<EdgeVotes> votes_;
};

TEST_F(CandidateEdgesTest, EveryCertifiedEdgeComesOnce)
{
  setPoints(noisySphere(400, 0.02), 12, 3.0f);
  for (const auto& edge : certified())
    EXPECT_EQ(edge.second, 1) << edge.first.first << " " << edge.first.second;
}

TEST_F(CandidateEdgesTest, EveryPlainEdgeComesOnce)
{
  setPoints(noisySphere(400, 0.02), 12, 3.0f);
  for (const auto& edge : plain())
    EXPECT_EQ(edge.second, 1) << edge.first.first << " " << edge.first.second;
}

TEST_F(CandidateEdgesTest, CertifiedEdgesAreAmongThePlainOnes)
{
  setPoints(noisySphere(400, 0.02), 12, 3.0f);
  const std::map<Edge, int> all = plain();
  for (const auto& edge : certified())
    EXPECT_EQ(all.count(edge.first), 1u);
}

/** A dense grid, and one point beside it that knows it but is not known. */
Positions
gridAndOutlier(double distance)
{
  Positions points;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      points.push_back({double(x), double(y), 0});
  points.push_back({4 + distance, 2, 0});
  return points;
}

TEST_F(CandidateEdgesTest, APointJustWithinReachOfTheOtherEndIsTried)
{
  setPoints(gridAndOutlier(2.5), 8, 3.0f);
  EXPECT_EQ(certified().count(Edge(22, 25)), 1u);
}

TEST_F(CandidateEdgesTest, AnEdgeBeyondTheReachOfTheEndThatDoesNotKnowItIsNotTried)
{
  setPoints(gridAndOutlier(6), 8, 3.0f);
  for (const auto& edge : plain())
    EXPECT_NE(edge.first.second, 25);
}

TEST_F(CandidateEdgesTest, AnEdgeHasTheLengthBetweenItsEnds)
{
  setPoints({{1e5, 0, 0}, {1e5 + 3, 4, 0}, {1e5, 5, 0}}, 2, 3.0f);
  const NeighborRows rows = cloud_->rows();
  const CandidateEdges edges(cloud_->points(), rows, votes_);
  edges.forPlain(
      0,
      [](index_t b) { return b == 1; },
      [](const CandidateEdge& edge, EdgeStanding) { EXPECT_EQ(edge.length, 5.0f); });
}

} // namespace
} // namespace pcl::ccaa::test
