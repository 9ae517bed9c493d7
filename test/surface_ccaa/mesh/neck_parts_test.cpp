// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which parts of a surface are necks between others.
#include <gtest/gtest.h>

#include "mesh/neck_parts.h"
#include "support/completion_shapes.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl::ccaa::test {
namespace {

using Where = std::function<bool(const Position&)>;

std::vector<std::vector<pcl::index_t>>
necksAt(const Shape& shape, const Where& is_flagged)
{
  std::vector<std::uint8_t> flags;
  for (const Position& vertex : shape.vertices)
    flags.push_back(is_flagged(vertex) ? 1 : 0);
  return neckParts(
      shape.triangles, adjacencyOf(shape), PointView(shape.vertices), flags);
}

/** A sphere that narrows to such a radius where z is 0. */
Shape
waist(double radius)
{
  Shape shape = icosphere(4);
  for (Position& vertex : shape.vertices) {
    const double share = radius + (1.0 - radius) * std::abs(vertex.z());
    vertex = {share * vertex.x(), share * vertex.y(), 2.0 * vertex.z()};
  }
  return shape;
}

bool
isMiddle(const Position& position)
{
  return std::abs(position.z()) < 0.2;
}

TEST(NeckParts, ABandAroundAWaistIsOneWithAllThatIsFlagged)
{
  const Shape shape = waist(0.2);
  const auto necks = necksAt(shape, isMiddle);
  ASSERT_EQ(1U, necks.size());
  for (std::size_t v = 0; v < shape.vertices.size(); ++v)
    if (isMiddle(shape.vertices[v])) {
      EXPECT_TRUE(std::binary_search(
          necks[0].begin(), necks[0].end(), static_cast<pcl::index_t>(v)));
    }
}

TEST(NeckParts, ABandAroundASphereIsNone)
{
  EXPECT_TRUE(necksAt(icosphere(4), isMiddle).empty());
}

TEST(NeckParts, AWaistThatGoesOnBesideThePartIsNone)
{
  EXPECT_TRUE(necksAt(waist(0.2), [](const Position& position) {
                return isMiddle(position) && position.x() < 0.1;
              }).empty());
}

TEST(NeckParts, TwoBandsAroundARingAreHandlesAndNoNecks)
{
  EXPECT_TRUE(necksAt(torus(80, 20, 1.0, 0.1), [](const Position& position) {
                return std::abs(position.y()) < 0.05;
              }).empty());
}

TEST(NeckParts, APatchIsNone)
{
  EXPECT_TRUE(necksAt(waist(0.2), [](const Position& position) {
                return position.z() > 1.5;
              }).empty());
}

TEST(NeckParts, WhatIsBehindOtherPartsCountsAsWell)
{
  // The upper half is cut into slices by parts, of which none is wide.
  const Shape shape = waist(0.2);
  const auto necks = necksAt(shape, [](const Position& position) {
    return isMiddle(position) || std::fmod(std::max(position.z(), 0.0), 0.6) > 0.4;
  });
  ASSERT_FALSE(necks.empty());
  EXPECT_TRUE(std::any_of(necks.begin(), necks.end(), [&](const auto& neck) {
    return isMiddle(shape.vertices[static_cast<std::size_t>(neck.front())]);
  }));
}

TEST(NeckParts, EachPieceHasItsOwn)
{
  const Shape one = waist(0.2);
  EXPECT_EQ(2U,
            necksAt(joined(one, translated(one, {5.0, 0.0, 0.0})), isMiddle).size());
}

TEST(NeckParts, NothingFlaggedIsNone)
{
  EXPECT_TRUE(necksAt(waist(0.2), [](const Position&) { return false; }).empty());
}

} // namespace
} // namespace pcl::ccaa::test
