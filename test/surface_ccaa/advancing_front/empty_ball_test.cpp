// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the smallest empty ball and the directions at a point.
#include <gtest/gtest.h>

#include "advancing_front/empty_ball.h"
#include "advancing_front/tangent_frame.h"
#include "support/random_source.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

Position
randomPosition(RandomSource& random)
{
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
  return {x, y, random.uniform(-1, 1)};
}

TEST(EmptyBall, HasTheCircumradiusOfARightTriangle)
{
  const EmptyBall ball({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
  EXPECT_NEAR(ball.circumradius(), 2.5, 1e-12);
}

TEST(EmptyBall, HasTheCircumradiusOfAnEquilateralTriangle)
{
  const EmptyBall ball({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_NEAR(ball.circumradius(), std::sqrt(2.0 / 3.0), 1e-12);
}

TEST(EmptyBall, WithoutWitnessesIsTheCircumscribedOne)
{
  const EmptyBall ball({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
  EXPECT_TRUE(ball.exists());
  EXPECT_NEAR(ball.radius(), ball.circumradius(), 1e-12);
}

TEST(EmptyBall, OfPointsOnALineIsInfinite)
{
  const EmptyBall ball({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_TRUE(std::isinf(ball.circumradius()));
}

TEST(EmptyBall, OfPointsOnALineDoesNotExist)
{
  const EmptyBall ball({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_FALSE(ball.exists());
}

TEST(EmptyBall, MovesAwayFromAWitnessAboveTheMiddle)
{
  // a ball through the unit circle and just past (0, 0, h) has its center at
  // (h^2 - 1) / 2h
  EmptyBall ball({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
  const double h = 0.5, center = (h * h - 1.0) / (2.0 * h);
  ball.exclude({0, 0, h});
  EXPECT_TRUE(ball.exists());
  EXPECT_NEAR(ball.radius(), std::hypot(1.0, center), 1e-12);
}

TEST(EmptyBall, DoesNotExistBetweenWitnessesOnBothSides)
{
  EmptyBall ball({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
  ball.exclude({0, 0, 0.5});
  ball.exclude({0, 0, -0.5});
  EXPECT_FALSE(ball.exists());
}

TEST(EmptyBall, DoesNotExistAroundAWitnessInItsPlane)
{
  EmptyBall ball({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
  ball.exclude({0.25, 0.25, 0});
  EXPECT_FALSE(ball.exists());
}

TEST(EmptyBall, IsNotDisturbedByAWitnessInItsPlaneOutside)
{
  EmptyBall ball({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
  ball.exclude({1.5, 0.25, 0});
  EXPECT_TRUE(ball.exists());
  EXPECT_NEAR(ball.radius(), 1.0, 1e-12);
}

TEST(EmptyBall, IsNotDisturbedByAWitnessOnItsCircle)
{
  EmptyBall ball({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  ball.exclude({1, 1, 0});
  EXPECT_TRUE(ball.exists());
  EXPECT_NEAR(ball.radius(), std::sqrt(0.5), 1e-12);
}

/** Radius of the smallest ball through three points without a witness inside: either
 * the circumscribed one, or one that touches a witness. Infinite when there is none. */
double
leastRadiusByTrying(const Position& a,
                    const Position& b,
                    const Position& c,
                    const Positions& witnesses)
{
  const Position u = b - a, v = c - a, normal = u.cross(v).normalized();
  const Position center =
      a + (u.squaredNorm() * v - v.squaredNorm() * u).cross(u.cross(v)) /
              (2.0 * u.cross(v).squaredNorm());
  Positions middles{center};
  for (const Position& w : witnesses) {
    // as far from w as from a
    const double t = ((w - center).squaredNorm() - (a - center).squaredNorm()) /
                     (2.0 * (w - center).dot(normal));
    middles.push_back(center + t * normal);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Position& middle : middles) {
    const double radius = (middle - a).norm();
    bool empty = true;
    for (const Position& w : witnesses)
      empty = empty && (w - middle).norm() >= radius - 1e-9;
    if (empty)
      least = std::min(least, radius);
  }
  return least;
}

TEST(EmptyBall, AgreesWithTryingAllBallsThatTouchAWitness)
{
  RandomSource random(3);
  int existing = 0, missing = 0;
  for (int round = 0; round < 2000; ++round) {
    const Position a = randomPosition(random), b = randomPosition(random),
                   c = randomPosition(random);
    EmptyBall ball(a, b, c);
    if (ball.circumradius() > 5.0)
      continue; // rounding grows with the radius
    Positions witnesses;
    for (int i = 0; i < 1 + round % 5; ++i)
      witnesses.push_back(randomPosition(random));
    for (const Position& w : witnesses)
      ball.exclude(w);
    const double expected = leastRadiusByTrying(a, b, c, witnesses);
    ASSERT_EQ(ball.exists(), std::isfinite(expected)) << round;
    if (ball.exists()) {
      ASSERT_NEAR(ball.radius(), expected, 1e-6 * expected) << round;
    }
    (ball.exists() ? existing : missing) += 1;
  }
  EXPECT_GT(existing, 500);
  EXPECT_GT(missing, 500);
}

TEST(EmptyBall, DoesNotDependOnTheOrderOfWitnesses)
{
  RandomSource random(8);
  for (int round = 0; round < 50; ++round) {
    const Position a = randomPosition(random), b = randomPosition(random),
                   c = randomPosition(random);
    const Position v = randomPosition(random), w = randomPosition(random);
    EmptyBall one(a, b, c), other(a, b, c);
    one.exclude(v);
    one.exclude(w);
    other.exclude(w);
    other.exclude(v);
    EXPECT_EQ(one.exists(), other.exists());
    EXPECT_EQ(one.radius(), other.radius());
  }
}

TEST(TangentFrame, CountsAnglesCounterClockwiseFromZero)
{
  const TangentFrame frame({1, 2, 3}, {0, 0, 2}, {2, 2, 3});
  EXPECT_NEAR(frame.angle({5, 2, 3}), 0.0, 1e-12);
  EXPECT_NEAR(frame.angle({1, 3, 3}), M_PI / 2, 1e-12);
  EXPECT_NEAR(frame.angle({0, 2, 3}), M_PI, 1e-12);
  EXPECT_NEAR(frame.angle({1, 0, 3}), 3 * M_PI / 2, 1e-12);
}

TEST(TangentFrame, SeesPointsFromAlongTheNormal)
{
  const TangentFrame flat({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const TangentFrame raised({0, 0, 0}, {0, 0, 1}, {1, 0, 0.7});
  EXPECT_NEAR(flat.angle({1, 1, 0}), raised.angle({1, 1, -5}), 1e-12);
}

TEST(TangentFrame, TurnsTheOtherWayWithTheNormalReversed)
{
  RandomSource random(4);
  for (int i = 0; i < 50; ++i) {
    const Position normal = randomPosition(random), zero = randomPosition(random),
                   point = randomPosition(random), origin = randomPosition(random);
    const double angle = TangentFrame(origin, normal, zero).angle(point);
    const double back = TangentFrame(origin, -normal, zero).angle(point);
    EXPECT_NEAR(angle + back, 2.0 * M_PI, 1e-9);
    EXPECT_GE(angle, 0.0);
    EXPECT_LT(angle, 2.0 * M_PI);
  }
}

} // namespace
} // namespace pcl::ccaa::test
