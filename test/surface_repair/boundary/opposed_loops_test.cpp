// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of finding loops that are the ends of one gap.

#include <gtest/gtest.h>

#include "boundary/opposed_loops.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;
using test::without;

std::vector<std::size_t>
opposedIn(const Shape& shape)
{
  return opposedLoops(extractBoundaries(modelOf(shape)));
}

/** Two loops of a shape that are opposed to each other, and no other ones. */
std::size_t
countPairs(const std::vector<std::size_t>& opposed)
{
  std::size_t members = 0;
  for (std::size_t loop = 0; loop < opposed.size(); ++loop)
    if (opposed[loop] != NONE)
      ++members;
  return members / 2;
}

/** Tubes of radius 1 and height 2 on one axis, the second one above the first. */
Shape
twoTubes(double gap)
{
  return joined(cylinder(32, 16), translated(cylinder(32, 16), {0.0, 0.0, 2.0 + gap}));
}

/** A ring without so much of its angle. */
Shape
torusWithoutSlice(double angle)
{
  return without(torus(96, 40), [angle](const Position& p) {
    return std::abs(std::atan2(p.y(), p.x())) < 0.5 * angle;
  });
}

/** A sphere without the belt |z| < half, pressed flat along x. */
Shape
halvedSphere(double half, double flatness)
{
  Shape shape = without(icosphere(4),
                        [half](const Position& p) { return std::abs(p.z()) < half; });
  for (Position& vertex : shape.vertices)
    vertex.x() *= flatness;
  return shape;
}

TEST(OpposedLoops, FacingMouthsOfTwoTubesAreOpposed)
{
  const auto opposed = opposedIn(twoTubes(0.5));
  ASSERT_EQ(4U, opposed.size());
  EXPECT_EQ(1U, countPairs(opposed));
}

TEST(OpposedLoops, OppositionIsMutual)
{
  const auto opposed = opposedIn(twoTubes(0.5));
  for (std::size_t loop = 0; loop < opposed.size(); ++loop)
    if (opposed[loop] != NONE) {
      EXPECT_EQ(loop, opposed[opposed[loop]]);
      EXPECT_NE(loop, opposed[loop]);
    }
}

TEST(OpposedLoops, TubesFarApartAreNotOpposed)
{
  EXPECT_EQ(0U, countPairs(opposedIn(twoTubes(4.0))));
}

TEST(OpposedLoops, TubesSideBySideAreNotOpposed)
{
  const Shape tubes =
      joined(cylinder(32, 16), translated(cylinder(32, 16), {2.5, 0.0, 0.0}));
  EXPECT_EQ(0U, countPairs(opposedIn(tubes)));
}

TEST(OpposedLoops, TheEndsOfARingWithoutASliceAreOpposed)
{
  const auto opposed = opposedIn(torusWithoutSlice(0.5));
  EXPECT_EQ((std::vector<std::size_t>{1, 0}), opposed);
}

TEST(OpposedLoops, TheOpeningsOfASphereBandAreNotOpposed)
{
  const Shape band =
      without(icosphere(4), [](const Position& p) { return std::abs(p.z()) > 0.5; });
  EXPECT_EQ((std::vector<std::size_t>{NONE, NONE}), opposedIn(band));
}

TEST(OpposedLoops, NeighbouringHolesOfASheetAreNotOpposed)
{
  const Shape sheet = without(grid(41, 21), [](const Position& p) {
    return std::min(std::hypot(p.x() - 15.0, p.y() - 10.0),
                    std::hypot(p.x() - 25.0, p.y() - 10.0)) < 4.0;
  });
  EXPECT_EQ(0U, countPairs(opposedIn(sheet)));
}

TEST(OpposedLoops, AHoleInARimIsNotOpposedToIt)
{
  const Shape sheet = without(grid(21, 21), [](const Position& p) {
    return std::hypot(p.x() - 10.0, p.y() - 10.0) < 8.0;
  });
  EXPECT_EQ((std::vector<std::size_t>{NONE, NONE}), opposedIn(sheet));
}

TEST(OpposedLoops, HalvesOfASphereAreOpposed)
{
  EXPECT_EQ((std::vector<std::size_t>{1, 0}), opposedIn(halvedSphere(0.1, 1.0)));
}

TEST(OpposedLoops, HalvesOfAFlattenedSphereAreOpposed)
{
  EXPECT_EQ((std::vector<std::size_t>{1, 0}), opposedIn(halvedSphere(0.1, 0.2)));
}

TEST(OpposedLoops, ScaleAndPlaceDoNotMatter)
{
  const Shape shape = torusWithoutSlice(0.5);
  for (const double factor : {1e-6, 1e6})
    EXPECT_EQ(opposedIn(shape),
              opposedIn(translated(scaled(shape, factor), {factor, 0.0, 0.0})));
}

/** The upper half of a sphere of radius 4 with a hole around its top, and a tube of
 * radius 1 above it, the lower end `height` above the top. */
BoundaryLoops
tubeOverHole(double height)
{
  const Shape half = without(scaled(icosphere(4), 4.0), [](const Position& p) {
    return p.z() < 0.0 || p.z() > 3.6;
  });
  return extractBoundaries(
      modelOf(joined(cylinder(32, 16), translated(half, {0.0, 0.0, -4.0 - height}))));
}

/** The lowest loop of the tube. */
std::size_t
lowerMouth(const BoundaryLoops& loops)
{
  std::size_t mouth = 0;
  while (std::abs(loops[mouth].length - 2.0 * M_PI) > 0.1 ||
         loops[mouth].curve.points.front().z() > 0.1)
    ++mouth;
  return mouth;
}

/** Curves of loops, by their height. */
std::vector<BoundaryCurve>
curvesOf(const Shape& shape)
{
  std::vector<BoundaryCurve> curves;
  for (const BoundaryLoop& loop : extractBoundaries(modelOf(shape)))
    curves.push_back(loop.curve);
  std::stable_sort(curves.begin(), curves.end(), [](const auto& a, const auto& b) {
    return a.points.front().z() < b.points.front().z();
  });
  return curves;
}

TEST(LookTheSameWay, OnlyMouthsOfTubesSideBySideDo)
{
  const auto one_above = curvesOf(twoTubes(0.5));
  EXPECT_FALSE(lookTheSameWay(one_above[1], one_above[2]));
  const auto beside = curvesOf(
      joined(cylinder(32, 16), translated(cylinder(32, 16), {2.5, 0.0, 0.01})));
  EXPECT_TRUE(lookTheSameWay(beside[0], beside[1]));
  EXPECT_TRUE(lookTheSameWay(beside[2], beside[3]));
}

TEST(LoopAhead, IsTheHoleThatAMouthLooksInto)
{
  const BoundaryLoops loops = tubeOverHole(2.0);
  const std::size_t ahead = loopAhead(loops, lowerMouth(loops));
  ASSERT_NE(NONE, ahead);
  EXPECT_NEAR(3.6 - 6.0, loops[ahead].curve.points.front().z(), 0.3);
}

TEST(LoopAhead, NeedNotLookBack)
{
  EXPECT_EQ(NONE, opposedLoops(tubeOverHole(2.0))[lowerMouth(tubeOverHole(2.0))]);
}

TEST(LoopAhead, IsNoneFurtherAwayThanAFewDiameters)
{
  const BoundaryLoops loops = tubeOverHole(9.0);
  EXPECT_EQ(NONE, loopAhead(loops, lowerMouth(loops)));
}

TEST(LoopAhead, IsNoneBehindTheMouth)
{
  const BoundaryLoops loops = tubeOverHole(2.0);
  std::size_t upper = lowerMouth(loops);
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (loops[k].curve.points.front().z() > loops[upper].curve.points.front().z())
      upper = k;
  EXPECT_EQ(NONE, loopAhead(loops, upper));
}

TEST(OpposedLoops, NoLoopsAreNoPairs) { EXPECT_TRUE(opposedLoops({}).empty()); }

} // namespace
} // namespace pcl::repair
