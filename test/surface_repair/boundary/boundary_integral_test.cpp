// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the boundary integral D.
#include <gtest/gtest.h>

#include "boundary/boundary_integral.h"
#include "boundary_models.h"
#include "support/random_source.h"
#include "support/shapes.h"

#include <cmath>

namespace pcl::repair::test {
namespace {

using ccaa::test::RandomSource;

/** \brief The plain way, for comparison. */
std::vector<std::size_t>
farthestByBruteForce(const Positions& points)
{
  std::vector<std::size_t> farthest;
  for (const Position& from : points) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if ((points[i] - from).squaredNorm() > (points[best] - from).squaredNorm())
        best = i;
    farthest.push_back(best);
  }
  return farthest;
}

/** \brief A circle in z = 0; `jag` moves each point in all directions. */
Positions
circle(std::size_t count, double jag = 0.0, std::uint64_t seed = 1)
{
  RandomSource random(seed);
  Positions points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(std::cos(angle) + jag * random.uniform(-1, 1),
                        std::sin(angle) + jag * random.uniform(-1, 1),
                        jag * random.uniform(-1, 1));
  }
  return points;
}

/** \brief The circle as the boundary of a surface that leans outward by an angle: 0 is
 * the plane around a hole, 90 degrees a tube below, 180 degrees a disc. */
BoundaryCurve
leaningCurve(const Positions& points, double angle)
{
  // Clockwise, so that what lies outside is on the left.
  BoundaryCurve curve{Positions(points.rbegin(), points.rend()), {}};
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Direction middle =
        (curve.points[k] + curve.points[curve.next(k)]).normalized();
    curve.normals.push_back(std::cos(angle) * Direction::UnitZ() +
                            std::sin(angle) * middle);
  }
  return curve;
}

TEST(FarthestPoints, AreThoseOfBruteForceOnSmoothAndJaggedCurves)
{
  for (const double jag : {0.0, 1e-4, 0.05, 0.5})
    for (const std::size_t count : {1, 2, 3, 8, 9, 100, 1000}) {
      const Positions points = circle(count, jag);
      EXPECT_EQ(farthestByBruteForce(points), farthestPoints(points))
          << count << " points, jag " << jag;
    }
}

TEST(FarthestPoints, AreThoseOfBruteForceOnPointsWithoutOrder)
{
  RandomSource random(7);
  Positions points;
  for (int i = 0; i < 1500; ++i)
    points.emplace_back(random.normal(), random.normal(), random.normal());
  EXPECT_EQ(farthestByBruteForce(points), farthestPoints(points));
}

TEST(FarthestPoints, AreTheLowestOfEquals)
{
  const Positions square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Positions many;
  for (int i = 0; i < 40; ++i)
    many.insert(many.end(), square.begin(), square.end());
  EXPECT_EQ(farthestByBruteForce(many), farthestPoints(many));
}

TEST(FarthestPoints, AreTheSameFarFromTheOrigin)
{
  Positions points = circle(500, 0.01);
  for (Position& point : points)
    point += Position(1e6, -1e6, 3e6);
  EXPECT_EQ(farthestByBruteForce(points), farthestPoints(points));
}

TEST(FarthestPoints, OfOnePlaceIsTheFirst)
{
  const Positions points(20000, Position(1, 2, 3));
  EXPECT_EQ(std::vector<std::size_t>(points.size(), 0), farthestPoints(points));
}

TEST(FarthestPoints, OfPointsOnALineAreItsEnds)
{
  Positions points;
  for (int i = 0; i < 100; ++i)
    points.emplace_back(i, 2 * i, -i);
  const auto farthest = farthestPoints(points);
  EXPECT_EQ(99u, farthest[10]);
  EXPECT_EQ(0u, farthest[90]);
}

TEST(FarthestPoints, OfNothingAreNothing) { EXPECT_TRUE(farthestPoints({}).empty()); }

/** So many that a square of their number would exceed the time limit of tests when
 * instrumented. */
TEST(FarthestPoints, OfACircleAreOpposite)
{
  const std::size_t count = 50000;
  const auto farthest = farthestPoints(circle(count));
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ((i + count / 2) % count, farthest[i]);
}

TEST(BoundaryIntegral, IsTheCosineOfTheLeanOnACircle)
{
  for (const double degrees : {0.0, 30.0, 60.0, 90.0, 120.0, 180.0}) {
    const double angle = degrees * M_PI / 180;
    const auto integral = boundaryIntegral(leaningCurve(circle(200), angle), 0.05);
    EXPECT_NEAR(std::cos(angle), integral.relative(), 1e-3) << degrees;
  }
}

TEST(BoundaryIntegral, GrowsWithTheCurve)
{
  Positions points = circle(200);
  for (Position& point : points)
    point *= 5;
  const auto integral = boundaryIntegral(leaningCurve(points, 0.0));
  EXPECT_NEAR(10 * M_PI, integral.length, 0.01);
  EXPECT_NEAR(10 * M_PI, integral.value, 0.5);
}

TEST(BoundaryIntegral, DoesNotDependOnWhereTheCurveBegins)
{
  BoundaryCurve curve = leaningCurve(circle(301, 0.02), 0.4);
  const double expected = boundaryIntegral(curve).value;
  std::rotate(curve.points.begin(), curve.points.begin() + 77, curve.points.end());
  std::rotate(curve.normals.begin(), curve.normals.begin() + 77, curve.normals.end());
  EXPECT_NEAR(expected, boundaryIntegral(curve).value, 1e-9);
}

TEST(BoundaryIntegral, OfAJaggedHoleIsClearlyPositive)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Positions points = circle(2000, 0.02, seed);
    for (Position& point : points)
      point.z() = 0;
    EXPECT_GT(boundaryIntegral(leaningCurve(points, 0.0)).relative(), 0.8);
  }
}

TEST(BoundaryIntegral, OfARimAndItsHoleAreOpposite)
{
  const Positions points = circle(150, 0.01);
  const double hole = boundaryIntegral(leaningCurve(points, 0.0)).value;
  EXPECT_NEAR(-hole, boundaryIntegral(leaningCurve(points, M_PI)).value, 1e-9);
}

TEST(BoundaryIntegral, OfHalfASphereIsZero)
{
  const auto half =
      without(ccaa::test::icosphere(4), [](const Position& p) { return p.z() > 0.0; });
  const BoundaryLoops loops = extractBoundaries(modelOf(half));
  ASSERT_EQ(1u, loops.size());
  EXPECT_NEAR(0.0, boundaryIntegral(loops[0].curve).relative(), 0.1);
}

TEST(BoundaryIntegral, OfNothingIsZero)
{
  EXPECT_EQ(0.0, boundaryIntegral({}).relative());
  EXPECT_EQ(0.0, boundaryIntegral({{{1, 1, 1}}, {{0, 0, 1}}}).value);
}

TEST(BoundaryIntegral, OfOnePlaceIsZeroAndFinite)
{
  const BoundaryCurve curve{Positions(5, Position(1, 1, 1)),
                            Directions(5, Direction::UnitZ())};
  EXPECT_EQ(0.0, boundaryIntegral(curve).relative());
}

} // namespace
} // namespace pcl::repair::test
