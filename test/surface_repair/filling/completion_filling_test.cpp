// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of closing holes by the base algorithm.

#include <gtest/gtest.h>

#include "filling/completion_filling.h"
#include "filling/disc_check.h"
#include "filling/minimum_weight_filling.h"
#include "filling_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::repair {
namespace {

using test::holeIn;
using test::HoleShape;

/** A hole of 60 edges with samples of the surface inside, `step` apart. */
FillingTask
sampledHole(const HoleShape& shape, double step = 0.1)
{
  FillingTask task = holeIn(shape);
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

TEST(CompletionFilling, SamplesBecomeInnerVertices)
{
  for (const auto& height : {test::capHeight, test::saddleHeight}) {
    const FillingTask task = sampledHole({60, height});
    const Filling filling = CompletionFilling().close(task);
    ASSERT_TRUE(isDisc(filling, 60));
    EXPECT_GT(filling.inner.size(), 0.9 * static_cast<double>(task.free_points.size()));
  }
}

TEST(CompletionFilling, InnerPointsAreTheFreePointsToTheBit)
{
  const FillingTask task = sampledHole({60, test::capHeight});
  const Filling filling = CompletionFilling().close(task);
  ASSERT_EQ(filling.inner.size(), filling.free_point.size());
  ASSERT_FALSE(filling.inner.empty());
  for (std::size_t k = 0; k < filling.inner.size(); ++k)
    EXPECT_EQ(task.free_points[filling.free_point[k]], filling.inner[k]);
}

TEST(CompletionFilling, SparseSamplesAreUsedToo)
{
  const FillingTask task = sampledHole({60, test::capHeight}, 0.4);
  const Filling filling = CompletionFilling().close(task);
  ASSERT_TRUE(isDisc(filling, 60));
  EXPECT_GT(filling.inner.size(), task.free_points.size() / 2);
}

TEST(CompletionFilling, OutlierMakesNoSpike)
{
  for (const double height : {0.5, 3.0, 100.0}) {
    FillingTask task = sampledHole({60});
    const std::size_t outlier = task.free_points.size();
    task.free_points.emplace_back(0.03, 0.02, height);
    const Filling filling = CompletionFilling().close(task);
    ASSERT_TRUE(isDisc(filling, 60));
    EXPECT_EQ(
        0, std::count(filling.free_point.begin(), filling.free_point.end(), outlier));
    EXPECT_GT(filling.inner.size(), outlier / 2);
  }
}

TEST(CompletionFilling, LoneFreePointFarOffIsLeft)
{
  FillingTask task = holeIn({40});
  task.free_points = {{0.0, 0.0, 5.0}};
  const Filling filling = CompletionFilling().close(task);
  EXPECT_TRUE(isDisc(filling, 40));
  EXPECT_TRUE(filling.inner.empty());
}

TEST(CompletionFilling, WithoutFreePointsItIsLeastWeight)
{
  const FillingTask task = holeIn({40, test::saddleHeight});
  EXPECT_EQ(MinimumWeightFilling().close(task).triangles,
            CompletionFilling().close(task).triangles);
}

TEST(CompletionFilling, HalfSampledHoleIsClosed)
{
  FillingTask task = sampledHole({60, test::capHeight});
  auto& points = task.free_points;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [](const Position& p) { return p.x() > -0.1; }),
               points.end());
  const Filling filling = CompletionFilling().close(task);
  EXPECT_TRUE(isDisc(filling, 60));
  EXPECT_GT(filling.inner.size(), points.size() / 2);
}

TEST(CompletionFilling, SamplesOnThePolygonNotFiniteOrTwiceAreLeft)
{
  FillingTask task = sampledHole({60, test::capHeight});
  const std::size_t good = task.free_points.size();
  task.free_points.push_back(task.polygon.points[3]);
  task.free_points.push_back(task.free_points[0]);
  task.free_points.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const Filling filling = CompletionFilling().close(task);
  ASSERT_TRUE(isDisc(filling, 60));
  for (const std::size_t index : filling.free_point)
    EXPECT_LT(index, good);
}

TEST(CompletionFilling, TrianglesLookToTheExternalSide)
{
  // Downward as well: the base algorithm chooses sides by itself.
  for (const bool turned : {false, true}) {
    FillingTask task = sampledHole({60});
    if (turned)
      for (auto* points : {&task.polygon.points, &task.free_points})
        for (Position& p : *points)
          p = Position(p.x(), -p.y(), -p.z());
    for (Direction& normal : task.polygon.normals)
      normal *= turned ? -1.0 : 1.0;
    const Filling filling = CompletionFilling().close(task);
    const Positions all = test::verticesOf(task, filling);
    for (const Triangle& t : filling.triangles)
      EXPECT_GT(ccaa::areaNormal(ccaa::cornersOf(t, all)).z() * (turned ? -1 : 1), 0.0);
  }
}

TEST(CompletionFilling, ObstructedTrianglesAreAvoided)
{
  FillingTask task = sampledHole({60});
  task.obstructed = [](const ccaa::Corners& c) {
    return ((c[0] + c[1] + c[2]) / 3.0 - Position(0.3, 0.1, 0.0)).norm() < 0.02;
  };
  const Filling filling = CompletionFilling().close(task);
  ASSERT_TRUE(isDisc(filling, 60));
  const Positions all = test::verticesOf(task, filling);
  for (const Triangle& t : filling.triangles)
    EXPECT_FALSE(task.obstructed(ccaa::cornersOf(t, all)));
}

TEST(CompletionFilling, SamplesThatSurroundTheHoleDoNotChangeIt)
{
  FillingTask task = sampledHole({60});
  const std::size_t inside = task.free_points.size();
  for (int k = 0; k < 200; ++k)
    task.free_points.emplace_back(
        1.6 * std::cos(0.0314 * k), 1.6 * std::sin(0.0314 * k), 0.0);
  const Filling filling = CompletionFilling().close(task);
  ASSERT_TRUE(isDisc(filling, 60));
  for (const std::size_t index : filling.free_point)
    EXPECT_LT(index, inside);
}

} // namespace
} // namespace pcl::repair
