// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the fan around the centre of a hole.

#include <gtest/gtest.h>

#include "filling/disc_check.h"
#include "filling/fan_filling.h"
#include "filling_samples.h"

namespace pcl::repair {
namespace {

using test::holeIn;

TEST(FanFilling, ClosesThreeEdgesByOneTriangle)
{
  const Filling filling = FanFilling().close(holeIn({3, test::saddleHeight}));
  EXPECT_TRUE(isDisc(filling, 3));
  EXPECT_TRUE(filling.inner.empty());
  EXPECT_EQ(1U, filling.triangles.size());
}

TEST(FanFilling, IsADiscOfOneTriangleAnEdge)
{
  for (const std::size_t edges : {4, 5, 12, 100}) {
    const Filling filling = FanFilling().close(holeIn({edges, test::capHeight}));
    EXPECT_TRUE(isDisc(filling, edges)) << edges;
    EXPECT_EQ(edges, filling.triangles.size());
  }
}

TEST(FanFilling, CentreDoesNotDependOnWhereTheBoundaryHasItsPoints)
{
  FillingTask square;
  square.polygon.points = {{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}};
  square.polygon.normals.assign(4, Direction::UnitZ());
  square.polygon.points.insert(square.polygon.points.begin() + 1, {0, 0.1, 0});
  square.polygon.points.insert(square.polygon.points.begin() + 1, {0, 0.05, 0});
  square.polygon.normals.assign(6, Direction::UnitZ());
  const Filling filling = FanFilling().close(square);
  ASSERT_EQ(1U, filling.inner.size());
  EXPECT_LT((filling.inner.front() - Position(1, 1, 0)).norm(), 1e-12);
}

TEST(FanFilling, InnerPointIsNoFreePoint)
{
  FillingTask task = holeIn({8});
  task.free_points = {Position::Zero()};
  EXPECT_EQ(std::vector<std::size_t>{NONE}, FanFilling().close(task).free_point);
}

TEST(FanFilling, TrianglesLookToTheExternalSide)
{
  const FillingTask task = holeIn({12});
  const Filling filling = FanFilling().close(task);
  const Positions all = test::verticesOf(task, filling);
  for (const Triangle& t : filling.triangles)
    EXPECT_GT(ccaa::areaNormal(ccaa::cornersOf(t, all)).z(), 0.0);
}

TEST(FanFilling, TwoEdgesAreNoHole)
{
  FillingTask task;
  task.polygon.points = {{0, 0, 0}, {1, 0, 0}};
  task.polygon.normals.assign(2, Direction::UnitZ());
  EXPECT_FALSE(FanFilling().close(task).closed());
}

} // namespace
} // namespace pcl::repair
