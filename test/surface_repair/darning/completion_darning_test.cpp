// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of closing holes by the base algorithm.

#include <gtest/gtest.h>

#include "darning/completion_darning.h"
#include "darning/disc_check.h"
#include "darning/minimum_weight_darning.h"
#include "darning_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl {
namespace repair {
namespace {

using test::holeIn;
using test::HoleShape;

/** A hole of 60 edges with samples of the surface inside, `step` apart. */
DarningTask
sampledHole(const HoleShape& shape, double step = 0.1)
{
  DarningTask task = holeIn(shape);
  ccaa::test::RandomSource random(7);
  for (double x = -1.0; x < 1.0; x += step)
    for (double y = -1.0; y < 1.0; y += step) {
      const double px = x + 0.3 * step * random.uniform(-1.0, 1.0);
      const double py = y + 0.3 * step * random.uniform(-1.0, 1.0);
      if (px * px + py * py < 0.85)
        task.free_points.emplace_back(px, py, shape.height(px, py));
    }
  return task;
}

TEST(CompletionDarning, SamplesBecomeInnerVertices)
{
  for (const auto& height : {test::capHeight, test::saddleHeight}) {
    const DarningTask task = sampledHole({60, height});
    const Darn darn = CompletionDarning().close(task);
    ASSERT_TRUE(isDisc(darn, 60));
    EXPECT_GT(darn.inner.size(), 0.9 * static_cast<double>(task.free_points.size()));
  }
}

TEST(CompletionDarning, InnerPointsAreTheFreePointsToTheBit)
{
  const DarningTask task = sampledHole({60, test::capHeight});
  const Darn darn = CompletionDarning().close(task);
  ASSERT_EQ(darn.inner.size(), darn.free_point.size());
  ASSERT_FALSE(darn.inner.empty());
  for (std::size_t k = 0; k < darn.inner.size(); ++k)
    EXPECT_EQ(task.free_points[darn.free_point[k]], darn.inner[k]);
}

TEST(CompletionDarning, SparseSamplesAreUsedToo)
{
  const DarningTask task = sampledHole({60, test::capHeight}, 0.4);
  const Darn darn = CompletionDarning().close(task);
  ASSERT_TRUE(isDisc(darn, 60));
  EXPECT_GT(darn.inner.size(), task.free_points.size() / 2);
}

TEST(CompletionDarning, OutlierMakesNoSpike)
{
  for (const double height : {0.5, 3.0, 100.0}) {
    DarningTask task = sampledHole({60});
    const std::size_t outlier = task.free_points.size();
    task.free_points.emplace_back(0.03, 0.02, height);
    const Darn darn = CompletionDarning().close(task);
    ASSERT_TRUE(isDisc(darn, 60));
    EXPECT_EQ(0, std::count(darn.free_point.begin(), darn.free_point.end(), outlier));
    EXPECT_GT(darn.inner.size(), outlier / 2);
  }
}

TEST(CompletionDarning, LoneFreePointFarOffIsLeft)
{
  DarningTask task = holeIn({40});
  task.free_points = {{0.0, 0.0, 5.0}};
  const Darn darn = CompletionDarning().close(task);
  EXPECT_TRUE(isDisc(darn, 40));
  EXPECT_TRUE(darn.inner.empty());
}

TEST(CompletionDarning, WithoutFreePointsItIsLeastWeight)
{
  const DarningTask task = holeIn({40, test::saddleHeight});
  EXPECT_EQ(MinimumWeightDarning().close(task).triangles,
            CompletionDarning().close(task).triangles);
}

TEST(CompletionDarning, HalfSampledHoleIsClosed)
{
  DarningTask task = sampledHole({60, test::capHeight});
  auto& points = task.free_points;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const Position& p) { return p.x() > -0.1; }),
               points.end());
  const Darn darn = CompletionDarning().close(task);
  EXPECT_TRUE(isDisc(darn, 60));
  EXPECT_GT(darn.inner.size(), points.size() / 2);
}

TEST(CompletionDarning, SamplesOnThePolygonNotFiniteOrTwiceAreLeft)
{
  DarningTask task = sampledHole({60, test::capHeight});
  const std::size_t good = task.free_points.size();
  task.free_points.push_back(task.polygon.points[3]);
  task.free_points.push_back(task.free_points[0]);
  task.free_points.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const Darn darn = CompletionDarning().close(task);
  ASSERT_TRUE(isDisc(darn, 60));
  for (const std::size_t index : darn.free_point)
    EXPECT_LT(index, good);
}

TEST(CompletionDarning, TrianglesLookToTheExternalSide)
{
  // Downward as well: the base algorithm chooses sides by itself.
  for (const bool turned : {false, true}) {
    DarningTask task = sampledHole({60});
    if (turned)
      for (auto* points : {&task.polygon.points, &task.free_points})
        for (Position& p : *points)
          p = Position(p.x(), -p.y(), -p.z());
    for (Direction& normal : task.polygon.normals)
      normal *= turned ? -1.0 : 1.0;
    const Darn darn = CompletionDarning().close(task);
    const Positions all = test::verticesOf(task, darn);
    for (const Triangle& t : darn.triangles)
      EXPECT_GT(ccaa::areaNormal(ccaa::cornersOf(t, all)).z() * (turned ? -1 : 1), 0.0);
  }
}

TEST(CompletionDarning, ObstructedTrianglesAreAvoided)
{
  DarningTask task = sampledHole({60});
  task.obstructed = [](const ccaa::Corners& c) {
    return ((c[0] + c[1] + c[2]) / 3.0 - Position(0.3, 0.1, 0.0)).norm() < 0.02;
  };
  const Darn darn = CompletionDarning().close(task);
  ASSERT_TRUE(isDisc(darn, 60));
  const Positions all = test::verticesOf(task, darn);
  for (const Triangle& t : darn.triangles)
    EXPECT_FALSE(task.obstructed(ccaa::cornersOf(t, all)));
}

TEST(CompletionDarning, SamplesThatSurroundTheHoleDoNotChangeIt)
{
  DarningTask task = sampledHole({60});
  const std::size_t inside = task.free_points.size();
  for (int k = 0; k < 200; ++k)
    task.free_points.emplace_back(
        1.6 * std::cos(0.0314 * k), 1.6 * std::sin(0.0314 * k), 0.0);
  const Darn darn = CompletionDarning().close(task);
  ASSERT_TRUE(isDisc(darn, 60));
  for (const std::size_t index : darn.free_point)
    EXPECT_LT(index, inside);
}

} // namespace
} // namespace repair
} // namespace pcl
