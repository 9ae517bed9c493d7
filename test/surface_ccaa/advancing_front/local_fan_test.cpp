// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the angular order around a point.
#include <gtest/gtest.h>

#include "advancing_front/local_fan.h"
#include "open_shapes.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

constexpr index_t SPOKES = 36;

/** Point 0 in the middle, points 1 to 36 around it at steps of 10 degrees; point i lies
 * at (i - 1) * 10 degrees. The fan covers the directions between some of them. */
Shape
wheel(index_t first, index_t last, double height = 0.0)
{
  Shape shape;
  shape.vertices.emplace_back(0, 0, 0);
  for (index_t i = 0; i < SPOKES; ++i) {
    const double angle = 2.0 * M_PI * i / SPOKES;
    shape.vertices.emplace_back(std::cos(angle), std::sin(angle), height);
  }
  for (index_t i = first; i < last; i += 3)
    shape.triangles.push_back({0, i, std::min<index_t>(i + 3, last)});
  return shape;
}

class LocalFan : public ::testing::TestWithParam<double> {};

/** Against arithmetic with degrees: the fan covers 0 to 180. */
TEST_P(LocalFan, TakesSectorsBesideTheFanOnly)
{
  const OpenSurface open = openSurfaceOf(wheel(1, 19, GetParam()));
  const GrowingSurface surface(open);
  for (index_t from = 1; from <= SPOKES; ++from)
    for (index_t to = 1; to <= SPOKES; ++to) {
      const int begin = 10 * (from - 1);
      const int width = (10 * (to - 1) - begin + 720) % 360; // counter-clockwise
      if (width == 0 || width > 170)
        continue;
      const int from_fan = (begin - 180 + 360) % 360; // 0 to 180 is free
      const bool expected = from_fan + width <= 180;
      EXPECT_EQ(fitsFans(surface, 0, from, to, {0, 0, 1}), expected)
          << begin << " + " << width;
    }
}

TEST_P(LocalFan, RefusesSectorsInClockwiseOrder)
{
  const OpenSurface open = openSurfaceOf(wheel(1, 19, GetParam()));
  const GrowingSurface surface(open);
  EXPECT_TRUE(fitsFans(surface, 0, 22, 26, {0, 0, 1}));
  EXPECT_FALSE(fitsFans(surface, 0, 26, 22, {0, 0, 1}));
}

TEST_P(LocalFan, FitsBetweenTwoFans)
{
  Shape shape = wheel(1, 10, GetParam());                      // 0 to 90 degrees
  const Triangles other = wheel(19, 28, GetParam()).triangles; // 180 to 270
  shape.triangles.insert(shape.triangles.end(), other.begin(), other.end());
  const OpenSurface open = openSurfaceOf(shape);
  const GrowingSurface surface(open);
  EXPECT_TRUE(fitsFans(surface, 0, 10, 19, {0, 0, 1}));  // 90 to 180
  EXPECT_TRUE(fitsFans(surface, 0, 28, 1, {0, 0, 1}));   // 270 to 360
  EXPECT_TRUE(fitsFans(surface, 0, 12, 16, {0, 0, 1}));  // 110 to 150
  EXPECT_FALSE(fitsFans(surface, 0, 12, 22, {0, 0, 1})); // 110 to 210
  EXPECT_FALSE(fitsFans(surface, 0, 20, 26, {0, 0, 1})); // 190 to 250
}

INSTANTIATE_TEST_SUITE_P(
    FlatAndBent, LocalFan, ::testing::Values(0.0, 0.2, -0.3), [](const auto& one) {
      return one.param == 0.0 ? "Flat" : one.param > 0.0 ? "Hollow" : "Domed";
    });

TEST(LocalFanAtAPoint, WithoutTrianglesTakesAnySector)
{
  const OpenSurface open = openPoints(wheel(1, 1).vertices);
  const GrowingSurface surface(open);
  EXPECT_TRUE(fitsFans(surface, 0, 3, 7, {0, 0, 1}));
}

TEST(LocalFanAtAPoint, RefusesATriangleThatFacesTheOtherWay)
{
  const OpenSurface open = openSurfaceOf(wheel(1, 19));
  const GrowingSurface surface(open);
  EXPECT_FALSE(fitsFans(surface, 0, 26, 22, {0, 0, -1}));
}

} // namespace
} // namespace pcl::ccaa::test
