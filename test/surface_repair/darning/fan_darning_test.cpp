// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the fan around the centre of a hole.

#include <gtest/gtest.h>

#include "darning/disc_check.h"
#include "darning/fan_darning.h"
#include "darning_samples.h"

namespace pcl {
namespace repair {
namespace {

using test::holeIn;

TEST(FanDarning, ClosesThreeEdgesByOneTriangle)
{
  const Darn darn = FanDarning().close(holeIn({3, test::saddleHeight}));
  EXPECT_TRUE(isDisc(darn, 3));
  EXPECT_TRUE(darn.inner.empty());
  EXPECT_EQ(1U, darn.triangles.size());
}

TEST(FanDarning, IsADiscOfOneTriangleAnEdge)
{
  for (const std::size_t edges : {4, 5, 12, 100}) {
    const Darn darn = FanDarning().close(holeIn({edges, test::capHeight}));
    EXPECT_TRUE(isDisc(darn, edges)) << edges;
    EXPECT_EQ(edges, darn.triangles.size());
  }
}

TEST(FanDarning, CentreDoesNotDependOnWhereTheBoundaryHasItsPoints)
{
  DarningTask square;
  square.polygon.points = {{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}};
  square.polygon.normals.assign(4, Direction::UnitZ());
  square.polygon.points.insert(square.polygon.points.begin() + 1, {0, 0.1, 0});
  square.polygon.points.insert(square.polygon.points.begin() + 1, {0, 0.05, 0});
  square.polygon.normals.assign(6, Direction::UnitZ());
  const Darn darn = FanDarning().close(square);
  ASSERT_EQ(1U, darn.inner.size());
  EXPECT_LT((darn.inner.front() - Position(1, 1, 0)).norm(), 1e-12);
}

TEST(FanDarning, InnerPointIsNoFreePoint)
{
  DarningTask task = holeIn({8});
  task.free_points = {Position::Zero()};
  EXPECT_EQ(std::vector<std::size_t>{NONE}, FanDarning().close(task).free_point);
}

TEST(FanDarning, TrianglesLookToTheExternalSide)
{
  const DarningTask task = holeIn({12});
  const Darn darn = FanDarning().close(task);
  const Positions all = test::verticesOf(task, darn);
  for (const Triangle& t : darn.triangles)
    EXPECT_GT(ccaa::areaNormal(ccaa::cornersOf(t, all)).z(), 0.0);
}

TEST(FanDarning, TwoEdgesAreNoHole)
{
  DarningTask task;
  task.polygon.points = {{0, 0, 0}, {1, 0, 0}};
  task.polygon.normals.assign(2, Direction::UnitZ());
  EXPECT_FALSE(FanDarning().close(task).closed());
}

} // namespace
} // namespace repair
} // namespace pcl
