// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the three-part compatibility test (thesis 3.3).
#include <gtest/gtest.h>

#include "greedy/edge_compatibility.h"
#include "ranked_cloud.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace pcl::ccaa::test {
namespace {

constexpr double DEGREE = M_PI / 180;

/** Points without neighbor rows, and the edges joined so far. */
class EdgeCompatibility : public ::testing::Test {
protected:
  void
  setPoints(const Positions& positions)
  {
    cloud_ = std::make_unique<RankedCloud>(positions, 1);
    joined_ = std::make_unique<JoinedEdges>(cloud_->points());
    triangles_.clear();
  }

  EdgeVerdict
  join(index_t a, index_t b, double limit = 0)
  {
    return joined_->join(a, b, AngleLimit::fromRadians(limit), triangles_);
  }

  void
  joinAll(const std::vector<std::pair<index_t, index_t>>& edges)
  {
    for (const auto& edge : edges)
      ASSERT_EQ(join(edge.first, edge.second), EdgeVerdict::JOINED);
  }

  std::unique_ptr<RankedCloud> cloud_;
  std::unique_ptr<JoinedEdges> joined_;
  Triangles triangles_;
};

const Positions SQUARE = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST_F(EdgeCompatibility, EdgeWithoutCommonNeighborMakesNoTriangle)
{
  setPoints(SQUARE);
  EXPECT_EQ(join(0, 1), EdgeVerdict::JOINED);
  EXPECT_TRUE(triangles_.empty());
}

TEST_F(EdgeCompatibility, EdgeMakesATriangleForEachCommonNeighbor)
{
  setPoints(SQUARE);
  joinAll({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  EXPECT_EQ(triangles_.size(), 2u);
}

TEST_F(EdgeCompatibility, SaysWhenAnEdgeIsThereAlready)
{
  setPoints(SQUARE);
  joinAll({{0, 1}});
  EXPECT_EQ(join(1, 0), EdgeVerdict::PRESENT);
}

TEST_F(EdgeCompatibility, Rule1RefusesAThirdTriangleOnAnEdgeThatIsThere)
{
  setPoints({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}});
  joinAll({{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {0, 4}});
  EXPECT_EQ(join(1, 4), EdgeVerdict::OVERFULL);
}

TEST_F(EdgeCompatibility, Rule1RefusesAnEdgeThatWouldGetThreeTrianglesItself)
{
  setPoints({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}});
  joinAll({{0, 2}, {1, 2}, {0, 3}, {1, 3}, {0, 4}, {1, 4}});
  EXPECT_EQ(join(0, 1), EdgeVerdict::OVERFULL);
}

TEST_F(EdgeCompatibility, Rule1RefusesTheSeventeenthEdgeAtAPoint)
{
  Positions star = {{0, 0, 0}};
  for (int i = 0; i < 17; ++i)
    star.push_back({std::cos(i * 0.3), std::sin(i * 0.3), 0});
  setPoints(star);
  for (index_t i = 1; i <= index_t(JoinedEdges::SLOTS); ++i)
    ASSERT_EQ(join(0, i), EdgeVerdict::JOINED);
  EXPECT_EQ(join(0, 17), EdgeVerdict::OVERFULL);
}

TEST_F(EdgeCompatibility, Rule2RefusesTheSecondDiagonalOfASquare)
{
  setPoints(SQUARE);
  joinAll({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  EXPECT_EQ(join(1, 3), EdgeVerdict::TETRAHEDRON);
}

TEST_F(EdgeCompatibility, Rule2RefusesTheSideThatClosesATetrahedronOverCrossedDiagonals)
{
  setPoints(SQUARE);
  joinAll({{0, 1}, {1, 2}, {2, 3}, {0, 2}, {1, 3}});
  EXPECT_EQ(join(3, 0), EdgeVerdict::TETRAHEDRON);
}

TEST_F(EdgeCompatibility, Rule2KnowsAPointInsideATriangleFromACrossing)
{
  setPoints({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}});
  joinAll({{3, 0}, {3, 1}, {3, 2}, {0, 1}, {1, 2}});
  EXPECT_EQ(join(2, 0), EdgeVerdict::JOINED);
}

TEST_F(EdgeCompatibility, LeavesOutTheTriangleAroundAPointInside)
{
  setPoints({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}});
  joinAll({{3, 0}, {3, 1}, {3, 2}, {0, 1}, {1, 2}, {2, 0}});
  ASSERT_EQ(triangles_.size(), 3u);
  for (const Triangle& t : triangles_)
    EXPECT_NE(std::find(t.begin(), t.end(), 3), t.end());
}

TEST_F(EdgeCompatibility, Rule3RefusesASmallAngleAtAnEnd)
{
  setPoints({{0, 0, 0}, {1, 0, 0}, {std::cos(10 * DEGREE), std::sin(10 * DEGREE), 0}});
  joinAll({{0, 1}});
  EXPECT_EQ(join(0, 2, 11 * DEGREE), EdgeVerdict::SMALL_ANGLE);
}

TEST_F(EdgeCompatibility, Rule3TakesAnAngleJustOverTheLimit)
{
  setPoints({{0, 0, 0}, {1, 0, 0}, {std::cos(12 * DEGREE), std::sin(12 * DEGREE), 0}});
  joinAll({{0, 1}});
  EXPECT_EQ(join(0, 2, 11 * DEGREE), EdgeVerdict::JOINED);
}

TEST_F(EdgeCompatibility, Rule3RefusesASmallAngleAtTheApex)
{
  const double far = 1 / std::tan(5 * DEGREE); // the edge is seen under 10 degrees
  setPoints({{-1, 0, 0}, {1, 0, 0}, {0, far, 0}});
  joinAll({{0, 2}, {1, 2}});
  EXPECT_EQ(join(0, 1, 11 * DEGREE), EdgeVerdict::SMALL_ANGLE);
}

TEST_F(EdgeCompatibility, ARefusedEdgeChangesNothing)
{
  setPoints(SQUARE);
  joinAll({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  join(1, 3);
  EXPECT_FALSE(joined_->areJoined(1, 3));
  EXPECT_EQ(triangles_.size(), 2u);
}

TEST_F(EdgeCompatibility, APointIsClosedWhenAllItsEdgesHaveTwoTriangles)
{
  setPoints({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}});
  joinAll({{3, 0}, {3, 1}, {3, 2}, {0, 1}, {1, 2}});
  EXPECT_FALSE(joined_->isClosed(3));
  joinAll({{2, 0}});
  EXPECT_TRUE(joined_->isClosed(3));
  EXPECT_FALSE(joined_->isClosed(0));
}

TEST_F(EdgeCompatibility, NoEdgeEverHasThreeTrianglesWhateverIsTried)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1);
    Positions positions;
    for (int i = 0; i < 30; ++i)
      positions.push_back({place(random), place(random), 0.3 * place(random)});
    setPoints(positions);
    std::uniform_int_distribution<index_t> pick(0, 29);
    for (int i = 0; i < 600; ++i) {
      const index_t a = pick(random), b = pick(random);
      if (a != b)
        join(a, b, DEGREE);
    }
    std::map<std::pair<index_t, index_t>, int> on_edge;
    for (const Triangle& t : triangles_)
      for (std::size_t c = 0; c < 3; ++c)
        ++on_edge[std::minmax(t[c], t[(c + 1) % 3])];
    for (const auto& edge : on_edge)
      ASSERT_LE(edge.second, 2) << "seed " << seed;
  }
}

} // namespace
} // namespace pcl::ccaa::test
