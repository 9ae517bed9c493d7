// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the normal that a force line has at a point.

#include <gtest/gtest.h>

#include "force_line/normal_search.h"

#include <cmath>
#include <random>

namespace pcl::repair {
namespace {

Eigen::Vector3d
randomVector(std::mt19937& generator)
{
  std::normal_distribution<double> number;
  const double x = number(generator);
  const double y = number(generator);
  return {x, y, number(generator)};
}

Tension
randomTension(std::mt19937& generator)
{
  Tension tension;
  for (int column = 0; column < 3; ++column)
    tension.col(column) = randomVector(generator);
  return tension;
}

TEST(NormalSearch, FindsTheGreatestTensionOfAllAngles)
{
  std::mt19937 generator(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Tension tension = randomTension(generator);
    const Direction across = randomVector(generator).normalized();
    const Direction first = across.unitOrthogonal();
    double greatest = 0.0;
    for (int step = 0; step < 20000; ++step) {
      const double angle = step * 1e-4 * 3.14159265358979;
      const Direction normal =
          std::cos(angle) * first + std::sin(angle) * across.cross(first);
      greatest = std::max(greatest, (tension * normal).norm());
    }
    EXPECT_NEAR(greatest, searchNormal(tension, across).tension, 1e-6 * greatest);
  }
}

TEST(NormalSearch, NormalHasTheTensionThatIsReported)
{
  std::mt19937 generator(2);
  const Tension tension = randomTension(generator);
  const FieldNormal found = searchNormal(tension, Direction::UnitX());
  EXPECT_NEAR(found.tension, (tension * found.normal).norm(), 1e-14);
}

TEST(NormalSearch, NormalIsAUnitVectorAcrossTheGivenDirection)
{
  std::mt19937 generator(3);
  const Direction across = randomVector(generator).normalized();
  const FieldNormal found = searchNormal(randomTension(generator), across);
  EXPECT_NEAR(1.0, found.normal.norm(), 1e-14);
  EXPECT_NEAR(0.0, found.normal.dot(across), 1e-14);
}

TEST(NormalSearch, OneSourceIsAnsweredAlongItsCompatibilityVector)
{
  const Eigen::Vector3d force(0.0, 2.0, 0.0);
  const Eigen::Vector3d compatibility(1.0, 0.0, 1.0);
  const FieldNormal found =
      searchNormal(force * compatibility.transpose(), Direction::UnitX());
  EXPECT_NEAR(1.0, std::abs(found.normal.z()), 1e-14);
  EXPECT_NEAR(2.0, found.tension, 1e-14);
  EXPECT_NEAR(1.0, found.clearness, 1e-14);
}

TEST(NormalSearch, EqualAnswersAllRoundAreNotClear)
{
  const FieldNormal found = searchNormal(Tension::Identity(), Direction::UnitY());
  EXPECT_NEAR(0.0, found.clearness, 1e-7);
}

TEST(NormalSearch, ZeroFieldHasNoTension)
{
  const FieldNormal found = searchNormal(Tension::Zero(), Direction::UnitY());
  EXPECT_EQ(0.0, found.tension);
  EXPECT_NEAR(1.0, found.normal.norm(), 1e-14);
}

} // namespace
} // namespace pcl::repair
