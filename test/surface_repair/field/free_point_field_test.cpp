// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of free points as sources of the scalar field G
// (4.424).
#include <gtest/gtest.h>

#include "field/free_point_field.h"
#include "field_samples.h"

#include <algorithm>

namespace pcl::repair::test {
namespace {

const Falloff REACH{0.05, 0.2, 1.0};

Positions
randomPoints(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points(count);
  for (Position& point : points)
    point = randomPosition(random);
  return points;
}

TEST(FreePointField, SumsTheTensionOfAllPoints)
{
  const FreePointField field(randomPoints(500, 1), REACH, 0.6);
  RandomSource random(2);
  for (int i = 0; i < 100; ++i) {
    const Position place = randomPosition(random);
    double sum = 0.0;
    for (const Position& point : field.points())
      sum += 1.5 * REACH((point - place).norm()); // G(0) = 0.6 / 0.4
    EXPECT_NEAR(field.tensionAt(place), sum, 1e-12);
  }
}

TEST(FreePointField, FindsAllPointsWithinARadiusInAscendingOrder)
{
  for (const double shift : {0.0, 1e5}) {
    Positions points = randomPoints(500, 3);
    for (Position& point : points)
      point.array() += shift;
    const FreePointField field(points, REACH, 0.5);
    const Position center = Position::Constant(0.5 + shift);
    std::vector<pcl::index_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if ((points[i] - center).norm() <= 0.3)
        expected.push_back(static_cast<pcl::index_t>(i));
    EXPECT_EQ(field.within(center, 0.3), expected);
  }
}

/** \brief E4.424-2 by many exact tensions. */
double
plainRatio(const FreePointField& field, const Position& a, const Position& b)
{
  constexpr int PARTS = 500;
  double sum = 0.0;
  for (int i = 0; i < PARTS; ++i)
    sum += 1.0 / (1.0 + field.tensionAt(a + (i + 0.5) / PARTS * (b - a)));
  return sum / PARTS;
}

TEST(FreePointField, MeasuresLengthsWithinAFewPercent)
{
  const FreePointField field(randomPoints(60, 4), REACH, 0.5);
  RandomSource random(5);
  double largest = 0.0, sum = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Position a = randomPosition(random), b = randomPosition(random);
    const double error = std::abs(field.lengthRatio(a, b) - plainRatio(field, a, b));
    largest = std::max(largest, error);
    sum += error;
  }
  EXPECT_LT(sum / 100, 0.02);
  EXPECT_LT(largest, 0.08);
}

TEST(FreePointField, ShortensWithinItsBounds)
{
  const FreePointField field(randomPoints(200, 6), REACH, 0.5);
  RandomSource random(7);
  for (int i = 0; i < 200; ++i) {
    const double ratio =
        field.lengthRatio(randomPosition(random), randomPosition(random));
    EXPECT_GT(ratio, 0.0);
    EXPECT_LE(ratio, 1.0);
  }
}

TEST(FreePointField, LeavesLengthsAwayFromPointsExactlyAsTheyAre)
{
  const FreePointField field(randomPoints(200, 8), REACH, 0.5);
  EXPECT_EQ(field.lengthRatio({2, 0, 0}, {2, 1, 1}), 1.0);
  EXPECT_EQ(field.lengthRatio({-1, -1, -1}, {1e7, -1, -1}), 1.0);
}

TEST(FreePointField, ChangesNothingWithoutPointsReachOrTrust)
{
  const Position a(0, 0, 0), b(1, 1, 1);
  EXPECT_EQ(FreePointField({}, REACH, 0.5).lengthRatio(a, b), 1.0);
  EXPECT_EQ(FreePointField(randomPoints(50, 9), {}, 0.5).lengthRatio(a, b), 1.0);
  EXPECT_EQ(FreePointField(randomPoints(50, 9), REACH, 0.0).lengthRatio(a, b), 1.0);
}

TEST(FreePointField, ShortensMoreTheMoreThePointsAreTrusted)
{
  double before = 1.0;
  for (const double trust : {0.1, 0.5, 0.9}) {
    const FreePointField field(randomPoints(200, 10), REACH, trust);
    const double ratio = field.lengthRatio({0, 0, 0}, {1, 1, 1});
    EXPECT_LT(ratio, before);
    before = ratio;
  }
}

} // namespace
} // namespace pcl::repair::test
