// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of GreedyStart on points that lie in lines.
#include "start_fixture.h"

#include <cmath>
#include <set>

namespace pcl::ccaa::test {
namespace {

constexpr int LINES = 24, POINTS_A_LINE = 200;

/** The root mean square of the distances 1, 1, 2, 2, 3 and 3. */
const double SPACING_ALONG = std::sqrt(28.0 / 6.0);

class ScanLinesApart : public GreedyStartTest,
                       public ::testing::WithParamInterface<double> {};

TEST_P(ScanLinesApart, AreJoined)
{
  const Positions points = terrainLines(LINES, POINTS_A_LINE, GetParam());
  // Two triangles a point, but for the border.
  EXPECT_GE(reconstruct(points).size(), 1.8 * (LINES - 1) * POINTS_A_LINE);
}

TEST_P(ScanLinesApart, AreToldInSpacingsAlongThem)
{
  reconstruct(terrainLines(LINES, POINTS_A_LINE, GetParam()));
  const double gap = GetParam() / SPACING_ALONG;
  EXPECT_NEAR(gap, start_.getReport().line_gap, 0.1 * gap);
}

TEST_P(ScanLinesApart, AreJoinedInNoiseOfHalfASpacing)
{
  const Positions points =
      withNoise(terrainLines(LINES, POINTS_A_LINE, GetParam()), 0.5);
  EXPECT_GE(usedPoints(reconstruct(points)), points.size() - points.size() / 100);
  EXPECT_GT(start_.getReport().line_gap, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Gaps, ScanLinesApart, ::testing::Values(7.0, 10.0, 20.0));

TEST_F(GreedyStartTest, SeesNoLinesInEvenPoints)
{
  reconstruct(bumpySphere(4000));
  EXPECT_EQ(0.0, start_.getReport().line_gap);
}

/** Two sheets beside lines: what lies between them has no points. */
TEST_F(GreedyStartTest, JoinsNothingFartherThatDoesNotLieInLines)
{
  Positions points = terrainLines(LINES, POINTS_A_LINE, 10.0);
  const std::size_t first = points.size();
  for (const double x : {0.0, 36.0}) // 30 wide, 7 apart
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j)
        points.emplace_back(x + i, j, 100.0 + 0.1 * std::sin(i + 2.0 * j));
  const Triangles triangles = reconstruct(points);
  ASSERT_GT(start_.getReport().line_gap, 0.0);
  std::size_t between = 0;
  for (const Triangle& t : triangles) {
    std::set<bool> sheets;
    for (const index_t corner : t)
      if (const auto c = static_cast<std::size_t>(corner); c >= first)
        sheets.insert(c < first + 900);
    between += sheets.size() > 1;
  }
  EXPECT_EQ(0u, between);
}

TEST_F(GreedyStartTest, DoesNotLookForLinesInThePlainAlgorithm)
{
  start_.setUseCertificates(false);
  reconstruct(terrainLines(LINES, POINTS_A_LINE, 10.0));
  EXPECT_EQ(0.0, start_.getReport().line_gap);
}

TEST_F(GreedyStartTest, EndsWhereAllPointsLieOnOneLine)
{
  EXPECT_TRUE(reconstruct(lineCloud(500)).empty());
}

} // namespace
} // namespace pcl::ccaa::test
