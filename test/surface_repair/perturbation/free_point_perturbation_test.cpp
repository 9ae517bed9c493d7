// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of free points that pull a line.

#include <gtest/gtest.h>

#include "perturbation/free_point_perturbation.h"

#include <cmath>

namespace pcl::repair {
namespace {

/** Along x from 0 to 2 in steps of 0.05, normals along z. */
ForceLine
straightLine()
{
  ForceLine line;
  line.end = LineEnd::BRIDGE;
  for (int k = 0; k <= 40; ++k) {
    line.points.emplace_back(0.05 * k, 0.0, 0.0);
    line.normals.push_back(Direction::UnitZ());
    line.tensions.push_back(1.0);
  }
  line.length = 2.0;
  return line;
}

constexpr std::size_t MIDDLE = 20;

FreePointField
fieldOf(Positions points)
{
  return FreePointField(std::move(points), {0.1, 0.4, 1.0}, 0.5);
}

double
greatestRise(const ForceLine& line)
{
  double rise = 0.0;
  for (const Position& point : line.points)
    rise = std::max(rise, std::abs(point.z()));
  return rise;
}

TEST(FreePointPerturbation, EndsKeepTheirBits)
{
  const FreePointField field = fieldOf({{0.02, 0.0, 0.1}, {1.99, 0.0, 0.2}});
  const ForceLine line = straightLine();
  const ForceLine moved = perturbed(line, field);
  EXPECT_EQ(line.points.front(), moved.points.front());
  EXPECT_EQ(line.points.back(), moved.points.back());
}

TEST(FreePointPerturbation, WithoutFreePointsNothingMoves)
{
  const ForceLine line = straightLine();
  EXPECT_EQ(line.points, perturbed(line, fieldOf({})).points);
}

TEST(FreePointPerturbation, UntrustedPointsMoveNothing)
{
  PerturbationParameters parameters;
  parameters.trust = 0.0;
  const ForceLine line = straightLine();
  EXPECT_EQ(line.points,
            perturbed(line, fieldOf({{1.0, 0.0, 0.1}}), parameters).points);
}

TEST(FreePointPerturbation, PointsOutsideTheCylinderMoveNothing)
{
  const ForceLine line = straightLine();
  const FreePointField field = fieldOf({{1.0, 0.0, 0.41}, {1.0, 0.41, 0.0}});
  EXPECT_EQ(line.points, perturbed(line, field).points);
}

TEST(FreePointPerturbation, OnePointOnTheNormalLinePullsByItsWeightAgainstThePointsOwn)
{
  PerturbationParameters parameters;
  parameters.trust = 0.75; // G(0) = 3
  const double displacement =
      displacementAt(straightLine(), MIDDLE, fieldOf({{1.0, 0.0, 0.2}}), parameters);
  EXPECT_NEAR(9.0 * 0.2 / (9.0 + 1.0), displacement, 1e-12); // E4.6-3, own weight 1
}

TEST(FreePointPerturbation, ToTheLetterOnePointPullsTheLineToItself)
{
  PerturbationParameters parameters;
  parameters.own_weight = 0.0;
  const FreePointField field = fieldOf({{1.0, 0.3, 0.2}});
  EXPECT_NEAR(0.2, displacementAt(straightLine(), MIDDLE, field, parameters), 1e-12);
}

TEST(FreePointPerturbation, PolesAreWeightedByTheSquareOfTheirTension)
{
  PerturbationParameters parameters;
  parameters.own_weight = 0.0;
  // One within R_1, the other half way from R_1 to R_2: tensions 1 and 0.5.
  const FreePointField field = fieldOf({{1.0, 0.05, 0.2}, {1.0, 0.25, -0.1}});
  EXPECT_NEAR((0.2 - 0.25 * 0.1) / 1.25,
              displacementAt(straightLine(), MIDDLE, field, parameters),
              1e-12);
}

TEST(FreePointPerturbation, SupportingPointHoldsTheLineNearIt)
{
  const ForceLine line = straightLine();
  PerturbationParameters parameters;
  parameters.own_weight = 0.0;
  const FreePointField field = fieldOf({{0.1, 0.0, 0.2}});
  // Point 2 lies 0.1 from the support, whose pole is the point itself: weights 1 and 1.
  EXPECT_NEAR(0.1, displacementAt(line, 2, field, parameters), 1e-12);
}

TEST(FreePointPerturbation, EqualPointsOnBothSidesCancelOut)
{
  const FreePointField field = fieldOf({{1.0, 0.0, 0.2}, {1.0, 0.0, -0.2}});
  EXPECT_LT(greatestRise(perturbed(straightLine(), field)), 1e-12);
}

TEST(FreePointPerturbation, OneOutlierPullsHalfWayAtMost)
{
  const FreePointField field = fieldOf({{1.0, 0.0, 0.35}});
  EXPECT_LE(greatestRise(perturbed(straightLine(), field)), 0.5 * 0.35 + 1e-12);
}

TEST(FreePointPerturbation, DisplacementGrowsWithoutAJump)
{
  const ForceLine moved = perturbed(straightLine(), fieldOf({{1.0, 0.0, 0.2}}));
  for (std::size_t k = 1; k < moved.points.size(); ++k)
    EXPECT_LT(std::abs(moved.points[k].z() - moved.points[k - 1].z()), 0.04);
}

TEST(FreePointPerturbation, DensePointsOnASurfaceAreNearlyReached)
{
  Positions points;
  for (int i = 0; i <= 40; ++i)
    for (int j = -6; j <= 6; ++j)
      points.emplace_back(0.05 * i, 0.05 * j, 0.15);
  const ForceLine moved = perturbed(straightLine(), fieldOf(points));
  EXPECT_NEAR(0.15, moved.points[MIDDLE].z(), 0.01);
}

TEST(FreePointPerturbation, NormalsStayAcrossTheLine)
{
  const ForceLine moved = perturbed(straightLine(), fieldOf({{1.0, 0.0, 0.2}}));
  for (std::size_t k = 1; k + 1 < moved.points.size(); ++k)
    EXPECT_NEAR(
        0.0, moved.normals[k].dot(moved.points[k + 1] - moved.points[k - 1]), 1e-12);
}

TEST(FreePointPerturbation, LengthIsThatOfTheMovedLine)
{
  const ForceLine moved = perturbed(straightLine(), fieldOf({{1.0, 0.0, 0.2}}));
  double length = 0.0;
  for (std::size_t k = 1; k < moved.points.size(); ++k)
    length += (moved.points[k] - moved.points[k - 1]).norm();
  EXPECT_DOUBLE_EQ(length, moved.length);
}

} // namespace
} // namespace pcl::repair
