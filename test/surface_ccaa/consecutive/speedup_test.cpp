// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of measuring whether a chain pays (C3.1-1).
#include "chain_fixture.h"
#include "consecutive/chain_results.h"

#include <chrono>
#include <thread>

namespace pcl::ccaa::test {
namespace {

using SpeedupTest = ConsecutiveTest;

/** 100 points that cost c_B = 1 s, c_F = 0.5 s and k = 0.9. */
ConsecutiveReport
madeUpReport()
{
  ConsecutiveReport report;
  report.points = 100;
  report.connected_points = 90;
  report.start_seconds = 100;
  report.filter_seconds = 50;
  report.total_seconds = 170;
  return report;
}

TEST_F(SpeedupTest, FiguresAreThoseOfTheThesis)
{
  const SpeedupReport speedup = compareSpeed(340, madeUpReport());
  EXPECT_DOUBLE_EQ(speedup.speedup, 2);
  EXPECT_DOUBLE_EQ(speedup.base_cost, 3.4);
  EXPECT_DOUBLE_EQ(speedup.start_cost, 1);
  EXPECT_DOUBLE_EQ(speedup.filter_cost, 0.5);
  EXPECT_DOUBLE_EQ(speedup.connected_share, 0.9);
  EXPECT_TRUE(speedup.is_advantageous);
}

TEST_F(SpeedupTest, TheConditionTurnsWhereTheCostsAreEqual)
{
  const double turn = 1.5 / 0.9 * 100; // k c_A = c_B + c_F
  EXPECT_TRUE(compareSpeed(turn * 1.001, madeUpReport()).is_advantageous);
  EXPECT_FALSE(compareSpeed(turn * 0.999, madeUpReport()).is_advantageous);
}

TEST_F(SpeedupTest, AFailedRunHasNoFigures)
{
  EXPECT_EQ(compareSpeed(1, ConsecutiveReport()).speedup, 0);
}

TEST_F(SpeedupTest, TheBaseRunsAloneFirstAndThenInTheChain)
{
  std::vector<std::size_t> given;
  chain_.setBaseAlgorithm(
      std::make_shared<ScriptedCompletion>([&](Polygons& polygons, const Cloud&) {
        given.push_back(polygons.size());
        if (polygons.empty())
          std::this_thread::sleep_for(std::chrono::milliseconds(300));
      }));
  chain_.setInputCloud(toCloud(bumpySphere(3000)));
  const SpeedupReport speedup = chain_.measureSpeedup();
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0], 0u);
  EXPECT_GT(given[1], 5000u);
  EXPECT_EQ(speedup.points, 3000u);
  EXPECT_GE(speedup.base_seconds, 0.3);
  EXPECT_DOUBLE_EQ(speedup.chain_seconds, chain_.getReport().total_seconds);
  EXPECT_DOUBLE_EQ(speedup.speedup, speedup.base_seconds / speedup.chain_seconds);
  EXPECT_DOUBLE_EQ(speedup.base_cost, speedup.base_seconds / 3000);
  EXPECT_DOUBLE_EQ(speedup.start_cost, chain_.getReport().startCost());
  EXPECT_GT(speedup.connected_share, 0.9);
  EXPECT_EQ(speedup.is_advantageous,
            speedup.connected_share * speedup.base_cost >
                speedup.start_cost + speedup.filter_cost);
  EXPECT_EQ(chain_.getTriangleLabels().size(), given[1]);
}

} // namespace
} // namespace pcl::ccaa::test
