// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of pieces that may belong together.

#include "support/repair_fixture.h"
#include "verification/piece_doubts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::repair {
namespace {

using namespace test;

/** A ball whose middle is new, so far above one of ten times its size whose top is, in
 * its diameter; the ends of the small one were joined around a bend.
 * \param[in] bend turn and fold of the junction, each */
std::vector<RepairDoubt>
doubtsAboutBall(double gap, double bend)
{
  const Shape body = icosphere(4);
  Shape ball = icosphere(2);
  for (Position& p : ball.vertices)
    p = 0.1 * p + Position(0.0, 0.0, 1.1 + 0.2 * gap);
  const Shape both = joined(body, ball);
  const auto is_new = [&](const Triangle& triangle) {
    const Position& p = both.vertices[static_cast<std::size_t>(triangle[0])];
    return p.z() < 1.0 ? p.z() > 0.95 : std::abs(p.x()) < 0.05;
  };
  RepairedModel repaired;
  IncompleteModel& model = repaired.model;
  model.triangles = both.triangles;
  const auto first_new =
      std::stable_partition(model.triangles.begin(),
                            model.triangles.end(),
                            [&](const Triangle& t) { return !is_new(t); });
  repaired.input_triangles =
      static_cast<std::size_t>(first_new - model.triangles.begin());
  model.positions = both.vertices;
  model.point_of_vertex.resize(model.positions.size());
  std::iota(model.point_of_vertex.begin(), model.point_of_vertex.end(), 0);
  model.adjacency.build(model.triangles, model.positions.size());
  model.island_of = ccaa::labelIslands(model.adjacency);
  RepairReport report;
  report.after.pieces = 2;
  report.junctions.resize(1);
  report.junctions.front().verdict = JunctionVerdict::JOINED;
  report.junctions.front().islands = {1, 2};
  const auto in_ball = static_cast<pcl::index_t>(body.vertices.size());
  report.junctions.front().points = {in_ball, in_ball + 1};
  report.junctions.front().evidence.turn = bend;
  report.junctions.front().evidence.fold = bend;
  report.junctions.front().evidence.gap_edges = 9.0;
  return doubtfulPieces(repaired, report, {});
}

TEST(PieceDoubts, APieceJoinedAroundABendBesideWhatIsNewElsewhereIsOne)
{
  const std::vector<RepairDoubt> doubts = doubtsAboutBall(0.4, 1.5);
  ASSERT_EQ(1U, doubts.size());
  EXPECT_EQ(DoubtReason::UNJOINED, doubts.front().reason);
  const double diagonal = std::sqrt(3.0); // of a cube around a ball of diameter 1
  EXPECT_NEAR(0.4 / diagonal, doubts.front().ratio, 0.05);
}

TEST(PieceDoubts, APieceJoinedStraightOrFarFromWhatIsNewElsewhereIsNone)
{
  EXPECT_TRUE(doubtsAboutBall(0.4, 0.2).empty());
  EXPECT_TRUE(doubtsAboutBall(2.0, 1.5).empty());
}

} // namespace
} // namespace pcl::repair
