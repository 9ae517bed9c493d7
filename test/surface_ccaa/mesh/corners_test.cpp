// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/corners.h.
#include <gtest/gtest.h>

#include "mesh/corners.h"

namespace pcl::ccaa::test {
namespace {

const Positions POSITIONS{{1, 1, 1}, {3, 1, 1}, {9, 9, 9}, {1, 2, 1}};

TEST(Corners, AreThePositionsOfATriangle)
{
  const Corners corners = cornersOf({3, 0, 1}, POSITIONS);
  EXPECT_EQ(corners[0], POSITIONS[3]);
  EXPECT_EQ(corners[1], POSITIONS[0]);
  EXPECT_EQ(corners[2], POSITIONS[1]);
}

TEST(Corners, RunCounterClockwiseSeenFromTheNormal)
{
  EXPECT_EQ(areaNormal(cornersOf({0, 1, 3}, POSITIONS)), Position(0, 0, 2));
  EXPECT_EQ(unitNormal(cornersOf({0, 1, 3}, POSITIONS)), Position(0, 0, 1));
  EXPECT_EQ(unitNormal(cornersOf({1, 0, 3}, POSITIONS)), Position(0, 0, -1));
}

TEST(Corners, HaveNoNormalWithoutArea)
{
  EXPECT_EQ(unitNormal(cornersOf({0, 1, 1}, POSITIONS)), Position(0, 0, 0));
}

} // namespace
} // namespace pcl::ccaa::test
