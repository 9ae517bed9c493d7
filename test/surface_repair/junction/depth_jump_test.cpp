// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what counts as a jump in depth of a sensor's view.

#include <gtest/gtest.h>

#include "boundary/extraction.h"
#include "junction/depth_jump.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using test::brokenCliff;
using test::modelOf;

const Position ABOVE(12.0, 12.0, 1000.0);
const Position BESIDE(1000.0, 12.0, 500.0);

/** The cliff as it is seen from a place. */
IncompleteModel
cliffFrom(const Position& sensor, double height)
{
  IncompleteModel model = modelOf(brokenCliff(height));
  model.viewpoints.assign(model.positions.size(), sensor);
  return model;
}

/** One level as seen from above, the other one from beside. */
IncompleteModel
cliffFromTwoPlaces(double height)
{
  IncompleteModel model = modelOf(brokenCliff(height));
  for (const Position& vertex : model.positions)
    model.viewpoints.push_back(vertex.x() > 11.5 ? ABOVE : BESIDE);
  return model;
}

/** Whether the one hole of a model is a jump. */
bool
isJump(const IncompleteModel& model)
{
  const BoundaryLoops loops = extractBoundaries(model);
  const auto hole =
      std::min_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
        return a.vertices.size() < b.vertices.size();
      });
  return isDepthJump(fillAreaOf(hole->curve), hole->curve, hole->vertices, model);
}

TEST(DepthJump, AGapBetweenTwoDepthsIsOne)
{
  EXPECT_TRUE(isJump(cliffFrom(ABOVE, 10)));
}

TEST(DepthJump, AHoleWithinALevelIsNone) { EXPECT_FALSE(isJump(cliffFrom(ABOVE, 0))); }

TEST(DepthJump, AGapOfAFewEdgesIsNone) { EXPECT_FALSE(isJump(cliffFrom(ABOVE, 2.5))); }

TEST(DepthJump, AGapThatTheSensorLooksIntoIsNone)
{
  EXPECT_FALSE(isJump(cliffFrom(BESIDE, 10)));
}

TEST(DepthJump, AGapWhoseRimTwoSensorsHaveMeasuredIsNone)
{
  EXPECT_FALSE(isJump(cliffFromTwoPlaces(10)));
}

TEST(DepthJump, WithoutASensorThereIsNone)
{
  EXPECT_FALSE(isJump(modelOf(brokenCliff(10))));
}

/** Whether the border, or else the hole, of a level is an outline. */
bool
isOutlineOf(const IncompleteModel& model, bool border)
{
  const BoundaryLoops loops = extractBoundaries(model);
  const std::size_t larger =
      loops[0].vertices.size() > loops[1].vertices.size() ? 0 : 1;
  const BoundaryLoop& loop = loops[border ? larger : 1 - larger];
  return isOutline(loop.curve, loop.vertices, model);
}

TEST(Outline, OfALevelIsItsBorderAndNotItsHole)
{
  const IncompleteModel model = cliffFrom(ABOVE, 0);
  EXPECT_TRUE(isOutlineOf(model, true));
  EXPECT_FALSE(isOutlineOf(model, false));
}

TEST(Outline, IsUnknownWithoutTheOneSensorThatHasMeasuredItAll)
{
  EXPECT_FALSE(isOutlineOf(modelOf(brokenCliff(0)), true));
  EXPECT_FALSE(isOutlineOf(cliffFromTwoPlaces(0), true));
}

} // namespace
} // namespace pcl::repair
