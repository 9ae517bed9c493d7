// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the surface as an obstacle (E4.43-6).
#include <gtest/gtest.h>

#include "field/shielding.h"
#include "field_samples.h"
#include "mesh/intersection.h"

namespace pcl::repair::test {
namespace {

bool
plainlyCrosses(const IncompleteModel& model, const Position& a, const Position& b)
{
  for (const Triangle& t : model.triangles)
    if (ccaa::segmentMeetsTriangle(a,
                                   b,
                                   {model.positions[static_cast<std::size_t>(t[0])],
                                    model.positions[static_cast<std::size_t>(t[1])],
                                    model.positions[static_cast<std::size_t>(t[2])]}))
      return true;
  return false;
}

TEST(Shield, AgreesWithATestOfAllTriangles)
{
  for (const ccaa::test::Shape& shape : {ccaa::test::icosphere(2),
                                         ccaa::test::torus(20, 11),
                                         ccaa::test::cube(5),
                                         ccaa::test::tetrahedron()}) {
    const IncompleteModel model = modelOf(shape);
    const Shield shield(model);
    RandomSource random(1);
    for (int i = 0; i < 500; ++i) {
      const Position a = 3.0 * randomPosition(random) - Position::Constant(1.5);
      const Position b = 3.0 * randomPosition(random) - Position::Constant(1.5);
      EXPECT_EQ(shield.crosses(a, b, 0.0), plainlyCrosses(model, a, b));
    }
  }
}

TEST(Shield, IsExactForSegmentsAlongTheAxes)
{
  const Shield shield(modelOf(ccaa::test::cube(4)));
  for (int axis = 0; axis < 3; ++axis) {
    Position a(0.25, 0.5, 0.5), b(0.25, 0.5, 0.5);
    a[axis] = -1.0;
    b[axis] = -1e-9;
    EXPECT_FALSE(shield.crosses(a, b, 0.0));
    b[axis] = 1e-9;
    EXPECT_TRUE(shield.crosses(a, b, 0.0));
  }
}

TEST(Shield, MissesNothingFarFromTheOriginOrTiny)
{
  for (const double scale : {1e-6, 1.0, 1e4})
    for (const double shift : {0.0, 1e5}) {
      const ccaa::test::Shape shape = ccaa::test::translated(
          ccaa::test::scaled(ccaa::test::icosphere(2), scale), {shift, -shift, shift});
      const Shield shield(modelOf(shape));
      const Position center(shift, -shift, shift);
      RandomSource random(2);
      for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(
            shield.crosses(center, center + 2 * scale * randomDirection(random), 0.0));
    }
}

TEST(Shield, DoesNotCountCrossingsCloseToAnEnd)
{
  const Shield shield(modelOf(ccaa::test::grid(5, 5)));
  const Position above(2.3, 2.4, 1.0);
  EXPECT_TRUE(shield.crosses(above, {2.3, 2.4, -0.2}, 0.1));
  EXPECT_FALSE(shield.crosses(above, {2.3, 2.4, -0.05}, 0.1));
  EXPECT_FALSE(shield.crosses({2.3, 2.4, -0.05}, above, 0.1));
}

TEST(Shield, LetsSegmentsEndOnABoundary)
{
  const Shield shield(modelOf(ccaa::test::grid(5, 5)));
  const Position edge(0.0, 2.5, 0.0);
  EXPECT_FALSE(shield.crosses({-2.0, 2.0, 0.5}, edge, 0.5));
  EXPECT_FALSE(shield.crosses({2.0, 2.0, 1.5}, edge, 0.5));
}

TEST(Shield, DoesNotStandBetweenPointsCloserThanTheTolerances)
{
  const Shield shield(modelOf(ccaa::test::grid(5, 5)));
  EXPECT_FALSE(shield.crosses({2.3, 2.4, 0.1}, {2.3, 2.4, -0.1}, 0.1));
  EXPECT_FALSE(shield.crosses({2.3, 2.4, 0.0}, {2.3, 2.4, 0.0}, 0.0));
}

TEST(Shield, PassesOverTrianglesWithoutAreaAndEmptyModels)
{
  EXPECT_FALSE(Shield(IncompleteModel()).crosses({0, 0, 0}, {1, 1, 1}, 0.0));
  IncompleteModel line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_FALSE(Shield(line).crosses({1, -1, 0}, {1, 1, 0}, 0.0));
}

} // namespace
} // namespace pcl::repair::test
