// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the triangulation of least weight in degenerate
// holes.

#include <gtest/gtest.h>

#include "filling/disc_check.h"
#include "filling_samples.h"

#include <cmath>

namespace pcl::repair {
namespace {

using test::fillingOf;
using test::meetings;

TEST(MinimumWeightFilling, DegenerateHolesGiveADisc)
{
  for (const auto& point : std::vector<std::function<Position(double)>>{
           [](double t) { return Position(t, 0, 0); },              // on a line
           [](double t) { return Position(1e-300 * t, 0, 0); },     // nearly one place
           [](double t) { return Position(std::cos(t), 1e-14, t); } // all but collinear
       }) {
    FillingTask task;
    for (int k = 0; k < 20; ++k)
      task.polygon.points.push_back(point(k));
    task.polygon.normals.assign(20, Direction::UnitZ());
    EXPECT_TRUE(isDisc(fillingOf(task), 20));
  }
}

TEST(MinimumWeightFilling, PointsOnALineGetNoFlatTriangle)
{
  FillingTask task; // a square, ten points a side
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < 10; ++k) {
      const Eigen::Vector2d along =
          Eigen::Rotation2Dd(-0.5 * M_PI * side) * Eigen::Vector2d(-5.0 + k, 5.0);
      task.polygon.points.emplace_back(along.x(), along.y(), 0.0);
    }
  task.polygon.normals.assign(40, Direction::UnitZ());
  const Filling filling = fillingOf(task);
  for (const Triangle& t : filling.triangles)
    EXPECT_GT(ccaa::areaNormal(ccaa::cornersOf(t, task.polygon.points)).z(), 0.5);
}

TEST(MinimumWeightFilling, CrackIsClosed)
{
  FillingTask task; // there and back on one line, the points of the two sides apart
  for (int k = 0; k < 10; ++k)
    task.polygon.points.emplace_back(k, 0.0, 0.0);
  for (int k = 10; k > 1; --k)
    task.polygon.points.emplace_back(k - 0.5, 0.0, 0.0);
  task.polygon.normals.assign(task.polygon.size(), Direction::UnitZ());
  const Filling filling = fillingOf(task);
  EXPECT_TRUE(isDisc(filling, task.polygon.size()));
  EXPECT_EQ(0U, meetings(task, filling));
}

TEST(MinimumWeightFilling, SpikeIsClosedByEars)
{
  FillingTask task = holeIn({40});
  task.polygon.points[7] *= 30.0;
  const Filling filling = fillingOf(task);
  EXPECT_TRUE(isDisc(filling, 40));
  EXPECT_EQ(0U, meetings(task, filling));
}

TEST(MinimumWeightFilling, NormalsThatAreNotThereAreNotAsked)
{
  FillingTask task = holeIn({30, test::capHeight});
  for (Direction& normal : task.polygon.normals)
    normal.setConstant(std::nan(""));
  EXPECT_TRUE(isDisc(fillingOf(task), 30));
}

} // namespace
} // namespace pcl::repair
