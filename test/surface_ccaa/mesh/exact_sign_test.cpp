// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/exact_sign.h.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/Geometry>

#include "mesh/exact_sign.h"
#include "support/random_source.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/** \brief The same determinant in rational numbers. */
int
rationalSide(const Position& a, const Position& b, const Position& c, const Position& d)
{
  Rational m[3][3];
  const Position* rows[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      m[i][k] = Rational((*rows[i])[k]) - Rational(d[k]);
  const Rational determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return -determinant.sign();
}

int
rationalTurn(const Position& a, const Position& b, const Position& c)
{
  const auto difference = [&](const Position& p, int axis) -> Rational {
    return Rational(p[axis]) - Rational(c[axis]);
  };
  const Rational determinant =
      difference(a, 0) * difference(b, 1) - difference(a, 1) * difference(b, 0);
  return determinant.sign();
}

/** \brief Whole numbers of up to so many bits. */
Position
wholePosition(RandomSource& random, int bits)
{
  Position position;
  for (double& coordinate : position)
    coordinate = std::round(std::ldexp(random.uniform(-1, 1), bits));
  return position;
}

Position
randomPosition(RandomSource& random)
{
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(ExactSign, SideIsPositiveWhereTheTriangleTurnsCounterClockwise)
{
  const Position a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(sideOfPlane(a, b, c, {0.2, 0.2, 1.0}), 1);
  EXPECT_EQ(sideOfPlane(a, b, c, {0.2, 0.2, -1.0}), -1);
  EXPECT_EQ(sideOfPlane(a, b, c, {5.0, 7.0, 0.0}), 0);
}

TEST(ExactSign, AgreesWithRationalNumbersNextToThePlane)
{
  RandomSource random(1);
  for (int i = 0; i < 2000; ++i) {
    const Position a = randomPosition(random), b = randomPosition(random),
                   c = randomPosition(random);
    const double u = random.uniform(), v = random.uniform();
    Position d = a + u * (b - a) + v * (c - a);
    if (i % 2 == 1)
      d.x() = std::nextafter(d.x(), 2.0);
    EXPECT_EQ(sideOfPlane(a, b, c, d), rationalSide(a, b, c, d));
  }
}

TEST(ExactSign, AgreesWithRationalNumbersFarFromTheOrigin)
{
  RandomSource random(2);
  const Position shift(494678.0, 5420315.0, 251.0);
  for (int i = 0; i < 500; ++i) {
    Position p[4];
    for (Position& point : p)
      point = (randomPosition(random) * 1e-3 + shift).cast<float>().cast<double>();
    EXPECT_EQ(sideOfPlane(p[0], p[1], p[2], p[3]),
              rationalSide(p[0], p[1], p[2], p[3]));
  }
}

TEST(ExactSign, AgreesWithRationalNumbersWhateverTheLengthOfTheCoordinates)
{
  RandomSource random(5);
  for (int bits = 2; bits < 52; ++bits)
    for (int i = 0; i < 40; ++i) {
      const Position a = wholePosition(random, bits), b = wholePosition(random, bits);
      const Position c = wholePosition(random, bits);
      Position fourth = a + (b - c), third = 2.0 * b - a; // in a plane, in a line
      fourth.x() += i % 3 - 1;
      third.x() += i % 3 - 1;
      EXPECT_EQ(sideOfPlane(a, b, c, fourth), rationalSide(a, b, c, fourth)) << bits;
      EXPECT_EQ(turnInPlane(a, b, third, 2), rationalTurn(a, b, third)) << bits;
    }
}

TEST(ExactSign, AgreesWithRationalNumbersWhenOneCoordinateIsTiny)
{
  RandomSource random(6);
  for (int exponent = 0; exponent > -200; exponent -= 3) {
    const Position a = wholePosition(random, 20), b = wholePosition(random, 20);
    const Position c = wholePosition(random, 20), fourth = a + (b - c);
    const double tiny = std::ldexp(1.0, exponent);
    const Position middle = 0.5 * (a + b);
    const Position lowered(a.x(), a.y(), a.z() == 0.0 ? tiny : 0.0);
    for (const double x : {-tiny, 0.0, tiny}) {
      const Position first(x, 0, 0), near(0, 0, x);
      EXPECT_EQ(sideOfPlane(first, near, fourth, lowered),
                rationalSide(first, near, fourth, lowered));
      EXPECT_EQ(turnInPlane(first, a, 2.0 * a, 2), rationalTurn(first, a, 2.0 * a));
      EXPECT_EQ(turnInPlane(a - middle, b - middle, first, 2),
                rationalTurn(a - middle, b - middle, first));
    }
  }
}

/** As in depth frames: edges along an axis, and faces across it. */
TEST(ExactSign, AgreesWithRationalNumbersWhereCoordinatesAreEqual)
{
  RandomSource random(17);
  std::size_t coplanar = 0;
  for (int i = 0; i < 5000; ++i) {
    const Position values[] = {randomPosition(random), randomPosition(random)};
    Position p[4];
    for (Position& point : p)
      for (Eigen::Index k = 0; k < 3; ++k)
        point[k] = values[random.uniform(0, 1) < 0.5 ? 0 : 1][k];
    const int side = rationalSide(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(sideOfPlane(p[0], p[1], p[2], p[3]), side);
    ASSERT_EQ(turnInPlane(p[0], p[1], p[2], 2), rationalTurn(p[0], p[1], p[2]));
    coplanar += side == 0;
  }
  EXPECT_GT(coplanar, 1000u);
  EXPECT_LT(coplanar, 4000u);
}

TEST(ExactSign, HoldsOverTheWholeRangeOfDoubles)
{
  RandomSource random(3);
  for (int i = 0; i < 500; ++i) {
    Position p[4];
    for (Position& point : p)
      for (int k = 0; k < 3; ++k)
        point[k] = std::ldexp(random.uniform(-1, 1),
                              static_cast<int>(random.uniform(-400.0, 400.0)));
    EXPECT_EQ(sideOfPlane(p[0], p[1], p[2], p[3]),
              rationalSide(p[0], p[1], p[2], p[3]));
  }
}

TEST(ExactSign, HoldsForTheSmallestNumbers)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(sideOfPlane({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}), 1);
  EXPECT_EQ(turnInPlane({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, 2), 1);
}

TEST(ExactSign, SwappingTwoPointsSwapsTheSign)
{
  RandomSource random(4);
  for (int i = 0; i < 200; ++i) {
    const Position a = randomPosition(random), b = randomPosition(random),
                   c = randomPosition(random), d = 0.5 * (a + b);
    EXPECT_EQ(sideOfPlane(a, b, c, d), -sideOfPlane(b, a, c, d));
  }
}

TEST(ExactSign, TurnIsPositiveCounterClockwiseInEveryPlane)
{
  const Position o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(turnInPlane(o, y, z, 0), 1);
  EXPECT_EQ(turnInPlane(o, z, x, 1), 1);
  EXPECT_EQ(turnInPlane(o, x, y, 2), 1);
  EXPECT_EQ(turnInPlane(o, y, x, 2), -1);
}

TEST(ExactSign, TurnOfThreePointsOnALineIsZero)
{
  const Position a(0.1, 0.3, 0), b(0.7, 0.9, 0), c = a + (b - a) * 0.5;
  EXPECT_EQ(turnInPlane({0, 0, 0}, {3, 3, 1}, {9, 9, 4}, 2), 0);
  EXPECT_EQ(turnInPlane(a, b, c, 2), -turnInPlane(b, a, c, 2));
}

TEST(ExactSign, NoAxisIsDroppableOnlyForCollinearPoints)
{
  EXPECT_EQ(droppableAxis({0, 0, 0}, {1, 2, 3}, {2, 4, 6}), -1);
  EXPECT_EQ(droppableAxis({1, 1, 1}, {1, 1, 1}, {2, 4, 6}), -1);
  EXPECT_EQ(droppableAxis({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 2);
  EXPECT_EQ(droppableAxis({0, 0, 0}, {1e-9, 0, 1}, {0, 1e-30, 1}) >= 0, true);
}

} // namespace
} // namespace pcl::ccaa::test
