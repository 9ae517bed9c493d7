// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what counts as a jump in depth of a sensor's view.

#include <gtest/gtest.h>

#include "boundary/extraction.h"
#include "junction/depth_jump.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace repair {
namespace {

using namespace ccaa::test;
using test::modelOf;

const Position ABOVE(12.0, 12.0, 1000.0);
const Position BESIDE(1000.0, 12.0, 500.0);

/** Two levels, the second one lower, joined by a cliff that lacks its middle. */
IncompleteModel
brokenCliff(double height)
{
  Shape shape = grid(24, 24);
  for (Position& vertex : shape.vertices)
    if (vertex.x() > 11.5)
      vertex.z() -= height;
  const auto is_lost = [&](const Triangle& triangle) {
    Position center = Position::Zero();
    for (const pcl::index_t corner : triangle)
      center += shape.vertices[static_cast<std::size_t>(corner)] / 3.0;
    return center.x() > 11.0 && center.x() < 12.0 && std::abs(center.y() - 12.0) < 5.0;
  };
  shape.triangles.erase(
      std::remove_if(shape.triangles.begin(), shape.triangles.end(), is_lost),
      shape.triangles.end());
  return modelOf(shape);
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
  IncompleteModel model = brokenCliff(10.0);
  model.viewpoints.assign(model.positions.size(), ABOVE);
  EXPECT_TRUE(isJump(model));
}

TEST(DepthJump, AHoleWithinALevelIsNone)
{
  IncompleteModel model = brokenCliff(0.0);
  model.viewpoints.assign(model.positions.size(), ABOVE);
  EXPECT_FALSE(isJump(model));
}

TEST(DepthJump, AGapOfAFewEdgesIsNone)
{
  IncompleteModel model = brokenCliff(2.5);
  model.viewpoints.assign(model.positions.size(), ABOVE);
  EXPECT_FALSE(isJump(model));
}

TEST(DepthJump, AGapThatTheSensorLooksIntoIsNone)
{
  IncompleteModel model = brokenCliff(10.0);
  model.viewpoints.assign(model.positions.size(), BESIDE);
  EXPECT_FALSE(isJump(model));
}

TEST(DepthJump, AGapWhoseRimTwoSensorsHaveMeasuredIsNone)
{
  IncompleteModel model = brokenCliff(10.0);
  for (const Position& vertex : model.positions)
    model.viewpoints.push_back(vertex.x() > 11.5 ? ABOVE : BESIDE);
  EXPECT_FALSE(isJump(model));
}

TEST(DepthJump, WithoutASensorThereIsNone) { EXPECT_FALSE(isJump(brokenCliff(10.0))); }

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
  IncompleteModel model = brokenCliff(0.0);
  model.viewpoints.assign(model.positions.size(), ABOVE);
  EXPECT_TRUE(isOutlineOf(model, true));
  EXPECT_FALSE(isOutlineOf(model, false));
}

TEST(Outline, IsUnknownWithoutTheOneSensorThatHasMeasuredItAll)
{
  IncompleteModel model = brokenCliff(0.0);
  EXPECT_FALSE(isOutlineOf(model, true));
  for (const Position& vertex : model.positions)
    model.viewpoints.push_back(vertex.x() > 11.5 ? ABOVE : BESIDE);
  EXPECT_FALSE(isOutlineOf(model, true));
}

} // namespace
} // namespace repair
} // namespace pcl
