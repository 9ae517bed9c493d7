// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of telling holes from rims and the outer border.
#include <gtest/gtest.h>

#include "boundary/classification.h"
#include "boundary_models.h"
#include "support/random_source.h"
#include "support/shapes.h"

#include <cmath>

namespace pcl::repair::test {
namespace {

using namespace ccaa::test;

/** \brief Classes of a shape's loops by their mean distance from the z axis, nearest
 * first. */
std::vector<BoundaryClass>
classesFromInside(const Shape& shape)
{
  const IncompleteModel model = modelOf(shape);
  const BoundaryLoops loops = extractBoundaries(model);
  const auto classes = classifyBoundaries(model, loops);
  std::vector<std::pair<double, BoundaryClass>> sorted;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    double distance = 0.0;
    for (const Position& point : loops[i].curve.points)
      distance += point.head<2>().norm();
    sorted.emplace_back(distance / static_cast<double>(loops[i].curve.size()),
                        classes[i].boundary_class);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<BoundaryClass> result;
  for (const auto& entry : sorted)
    result.push_back(entry.second);
  return result;
}

LoopClass
onlyClass(const Shape& shape, const ClassificationParameters& parameters = {})
{
  const IncompleteModel model = modelOf(shape);
  const auto classes = classifyBoundaries(model, extractBoundaries(model), parameters);
  EXPECT_EQ(1u, classes.size());
  return classes.empty() ? LoopClass() : classes[0];
}

/** \brief A square with the z axis in its middle. */
Shape
square(int columns)
{
  return translated(grid(columns, columns),
                    Position(-0.5 * (columns - 1), -0.5 * (columns - 1), 0));
}

double
fromAxis(const Position& p)
{
  return p.head<2>().norm();
}

/** \brief What is left of a unit sphere below a height. */
Shape
sphereBelow(double height)
{
  return without(icosphere(4), [=](const Position& p) { return p.z() > height; });
}

TEST(Classification, TheEdgeOfASheetIsItsOuterBorder)
{
  const LoopClass found = onlyClass(square(20));
  EXPECT_EQ(BoundaryClass::OUTER_BORDER, found.boundary_class);
  EXPECT_EQ(0.0, found.faced);
  EXPECT_GT(found.confidence, 0.9);
}

TEST(Classification, AHoleInASheetIsAHole)
{
  const Shape shape =
      without(square(40), [](const Position& p) { return fromAxis(p) < 5; });
  EXPECT_EQ(
      (std::vector<BoundaryClass>{BoundaryClass::HOLE, BoundaryClass::OUTER_BORDER}),
      classesFromInside(shape));
}

TEST(Classification, ARingShapedGapHasAHoleOutsideAndARimInside)
{
  const Shape shape = without(square(60), [](const Position& p) {
    return fromAxis(p) > 6 && fromAxis(p) < 13;
  });
  EXPECT_EQ((std::vector<BoundaryClass>{BoundaryClass::ISLAND_RIM,
                                        BoundaryClass::HOLE,
                                        BoundaryClass::OUTER_BORDER}),
            classesFromInside(shape));
}

TEST(Classification, ASmallIslandInAWideHoleIsARim)
{
  const Shape shape = without(square(60), [](const Position& p) {
    return fromAxis(p) > 1.5 && fromAxis(p) < 20;
  });
  EXPECT_EQ(BoundaryClass::ISLAND_RIM, classesFromInside(shape).at(0));
}

TEST(Classification, AFragmentBesideASheetLeavesTheSheetItsOuterBorder)
{
  const Shape shape = joined(square(40), translated(grid(4, 4), Position(25, 0, 0)));
  EXPECT_EQ((std::vector<BoundaryClass>{BoundaryClass::OUTER_BORDER,
                                        BoundaryClass::ISLAND_RIM}),
            classesFromInside(shape));
}

TEST(Classification, TheInnerLoopOfANarrowFrameIsAHole)
{
  const Shape shape =
      without(square(60), [](const Position& p) { return fromAxis(p) < 26; });
  const Shape frame =
      without(shape, [](const Position& p) { return fromAxis(p) > 29; });
  EXPECT_EQ(
      (std::vector<BoundaryClass>{BoundaryClass::HOLE, BoundaryClass::OUTER_BORDER}),
      classesFromInside(frame));
}

TEST(Classification, TheRimOfRollingTerrainIsItsOuterBorder)
{
  for (const double amplitude : {0.5, 2.0, 6.0})
    EXPECT_EQ(BoundaryClass::OUTER_BORDER,
              onlyClass(terrain(40, 40, amplitude)).boundary_class);
}

TEST(Classification, ASphereWithASmallOpeningHasAHole)
{
  for (const double height : {0.4, 0.6, 0.9})
    EXPECT_EQ(BoundaryClass::HOLE, onlyClass(sphereBelow(height)).boundary_class);
}

TEST(Classification, ACapOfASphereHasARim)
{
  for (const double height : {-0.9, -0.6, -0.3})
    EXPECT_EQ(BoundaryClass::OUTER_BORDER,
              onlyClass(sphereBelow(height)).boundary_class);
}

TEST(Classification, HalfASphereIsUndecided)
{
  const LoopClass found = onlyClass(sphereBelow(0.0));
  EXPECT_EQ(BoundaryClass::UNDECIDED, found.boundary_class);
  EXPECT_LT(found.confidence, 0.2);
}

TEST(Classification, TheMouthsOfATubeAreUndecided)
{
  for (const double height : {1.0, 3.0, 8.0})
    EXPECT_EQ((std::vector<BoundaryClass>(2, BoundaryClass::UNDECIDED)),
              classesFromInside(cylinder(40, 20, 1.0, height)));
}

/** D is about 0 here: it is the size of the body that tells. */
TEST(Classification, TheStumpOfALimbIsAHole)
{
  Shape body = icosphere(5);
  for (Position& p : body.vertices)
    if (p.z() > 0.8) // the cap around the pole becomes a limb
      p.z() = 0.8 + 10 * (p.z() - 0.8);
  const Shape stump = without(body, [](const Position& p) { return p.z() > 2.0; });
  const LoopClass found = onlyClass(stump);
  EXPECT_LT(std::abs(found.evidence.integral.relative()), 0.4);
  EXPECT_EQ(BoundaryClass::HOLE, found.boundary_class);
}

TEST(Classification, ASaddleKeepsItsOuterBorder)
{
  Shape saddle = square(30);
  for (Position& p : saddle.vertices)
    p.z() = 0.03 * (p.x() * p.x() - p.y() * p.y());
  EXPECT_EQ(BoundaryClass::OUTER_BORDER, onlyClass(saddle).boundary_class);
}

TEST(Classification, TheWindingOfAnIslandDoesNotMatter)
{
  Shape shape = without(square(40), [](const Position& p) { return fromAxis(p) < 5; });
  shape.triangles = reversed(shape.triangles);
  EXPECT_EQ(
      (std::vector<BoundaryClass>{BoundaryClass::HOLE, BoundaryClass::OUTER_BORDER}),
      classesFromInside(shape));
}

TEST(Classification, DoesNotDependOnTheScale)
{
  const Shape shape = sphereBelow(0.5);
  const double expected = onlyClass(shape).evidence.score();
  for (const double factor : {1e-6, 1e6})
    EXPECT_NEAR(expected, onlyClass(scaled(shape, factor)).evidence.score(), 1e-6);
}

TEST(Classification, AJaggedNoisyHoleIsAHole)
{
  RandomSource random(3);
  Shape shape = square(60);
  for (Position& p : shape.vertices)
    p += 0.2 * Position(random.normal(), random.normal(), random.normal());
  shape = without(shape, [&](const Position& p) {
    return fromAxis(p) < 10 + 4 * random.uniform();
  });
  const IncompleteModel model = modelOf(shape);
  if (isManifold(model.adjacency)) {
    const auto classes = classesFromInside(shape);
    EXPECT_EQ(BoundaryClass::OUTER_BORDER, classes.back());
    EXPECT_EQ(BoundaryClass::HOLE, classes[classes.size() - 2]);
  }
}

TEST(Classification, OneSidedIslandsAreUndecided)
{
  const LoopClass found = onlyClass(moebiusBand(40));
  EXPECT_EQ(BoundaryClass::UNDECIDED, found.boundary_class);
  EXPECT_EQ(0.0, found.confidence);
}

TEST(Classification, MoreIsUndecidedWhereMoreConfidenceIsAsked)
{
  ClassificationParameters strict;
  strict.decided_from = 1.0;
  EXPECT_EQ(BoundaryClass::UNDECIDED, onlyClass(square(5), strict).boundary_class);
}

TEST(Classification, FlatRimsAndHolesHaveTheEvidenceOfTheirClosedForms)
{
  const LoopClass rim = onlyClass(square(20));
  EXPECT_NEAR(-1.0, rim.evidence.turning, 1e-9);
  EXPECT_NEAR(1.0, rim.evidence.area_ratio, 1e-9);
  const LoopClass sphere = onlyClass(sphereBelow(0.6));
  EXPECT_NEAR(0.6, sphere.evidence.turning, 0.05); // the cosine of the opening
  EXPECT_LT(sphere.evidence.area_ratio, 5.0);      // 2 / (1 - cosine), if not jagged
  EXPECT_GT(sphere.evidence.area_ratio, 3.5);
}

TEST(Classification, ATriangleIsARim)
{
  const Shape triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(BoundaryClass::OUTER_BORDER, onlyClass(triangle).boundary_class);
}

TEST(Classification, ATriangleWithoutAreaHasFiniteEvidence)
{
  const Shape line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const Shape point{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
  for (const Shape& shape : {line, point})
    EXPECT_TRUE(std::isfinite(onlyClass(shape).evidence.score()));
}

TEST(Classification, IsTheSameForAnyNumberOfThreads)
{
  Shape shape = square(60);
  RandomSource random(5);
  shape = without(shape, [&](const Position&) { return random.uniform() < 0.002; });
  const IncompleteModel model = modelOf(shape);
  const BoundaryLoops loops = extractBoundaries(model);
  const auto expected = classifyBoundaries(model, loops);
  const auto found =
      classifyBoundaries(model, loops, {}, ccaa::LoopContext{4, nullptr, "", 1});
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(expected[i].evidence.score(), found[i].evidence.score());
}

TEST(Classification, EveryClassHasAName)
{
  EXPECT_STREQ("hole", describe(BoundaryClass::HOLE));
  EXPECT_STREQ("island rim", describe(BoundaryClass::ISLAND_RIM));
  EXPECT_STREQ("outer border", describe(BoundaryClass::OUTER_BORDER));
  EXPECT_STREQ("undecided", describe(BoundaryClass::UNDECIDED));
}

TEST(Classification, HolesThatMeetInAPointAreHoles)
{
  for (const std::size_t holes : {2U, 3U}) {
    const IncompleteModel model = readingOf(pinchedSphere(holes));
    for (const LoopClass& loop : classifyBoundaries(model, extractBoundaries(model)))
      EXPECT_EQ(BoundaryClass::HOLE, loop.boundary_class);
  }
}

TEST(Classification, AHoleThatMeetsTheBorderIsToldFromIt)
{
  const IncompleteModel model = readingOf(pinchedBorder());
  const BoundaryLoops loops = extractBoundaries(model);
  const auto classes = classifyBoundaries(model, loops);
  ASSERT_EQ(2U, loops.size());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(loops[i].vertices.size() == 3,
              classes[i].boundary_class == BoundaryClass::HOLE);
}

} // namespace
} // namespace pcl::repair::test
