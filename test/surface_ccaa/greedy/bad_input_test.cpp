// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what GreedyStart does with clouds it can make nothing of.
#include "start_fixture.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

using GreedyStartBadInput = GreedyStartTest;

TEST_F(GreedyStartBadInput, UpToTwoPointsGiveNothing)
{
  for (const std::size_t count : {0u, 1u, 2u})
    EXPECT_TRUE(
        reconstruct(Positions(count, Position(1, 2, 3) * double(count))).empty());
}

TEST_F(GreedyStartBadInput, ThreePointsGiveOneTriangle)
{
  EXPECT_EQ(reconstruct(Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 1u);
}

TEST_F(GreedyStartBadInput, PointsOnALineGiveNothing)
{
  EXPECT_TRUE(reconstruct(lineCloud(100)).empty());
}

TEST_F(GreedyStartBadInput, AMillionIdenticalPointsGiveNothing)
{
  EXPECT_TRUE(reconstruct(Positions(1000000, Position(1, 1, 1))).empty());
}

TEST_F(GreedyStartBadInput, AMillionIdenticalPointsDoNotHangTheKdTree)
{
  start_.setSearchMethod(nullptr);
  EXPECT_TRUE(reconstruct(Positions(1000000, Position(1, 1, 1))).empty());
}

TEST_F(GreedyStartBadInput, OnlyNonFinitePointsGiveNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(reconstruct(Positions(10, Position(nan, 0, nan))).empty());
}

TEST_F(GreedyStartBadInput, AnIndexOutsideTheCloudGivesNothing)
{
  start_.setIndices(std::make_shared<Indices>(Indices{0, 1, 2, 500}));
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
}

TEST_F(GreedyStartBadInput, ParametersOutOfRangeGiveNothing)
{
  const Positions points = fibonacciSphere(100);
  start_.setNumberOfNeighbors(2);
  EXPECT_TRUE(reconstruct(points).empty());
  start_.setNumberOfNeighbors(65);
  EXPECT_TRUE(reconstruct(points).empty());
  start_.setNumberOfNeighbors(16);
  start_.setMinimumAngle(-0.1);
  EXPECT_TRUE(reconstruct(points).empty());
  start_.setMinimumAngle(std::nan(""));
  EXPECT_TRUE(reconstruct(points).empty());
  start_.setMinimumAngle(0.2);
  start_.setLengthFactor(0.5);
  EXPECT_TRUE(reconstruct(points).empty());
  start_.setLengthFactor(3);
  EXPECT_FALSE(reconstruct(points).empty());
}

} // namespace
} // namespace pcl::ccaa::test
