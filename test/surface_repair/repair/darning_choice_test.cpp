// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which darning method closes a hole.

#include <gtest/gtest.h>

#include "repair/darning_choice.h"
#include "surface_repair/darning/darning_samples.h"

#include <algorithm>
#include <string>

namespace pcl {
namespace repair {
namespace {

using test::capHeight;
using test::holeIn;
using test::HoleShape;

DarningTask
capHole()
{
  return holeIn(HoleShape{24, capHeight, 0.0});
}

/** Points on the cap over the hole, at equal steps in x and y. */
FreePointField
pointsOnTheCap(double step)
{
  Positions points;
  for (double x = -0.9; x <= 0.9; x += step)
    for (double y = -0.9; y <= 0.9; y += step)
      if (std::hypot(x, y) < 0.9)
        points.emplace_back(x, y, capHeight(x, y));
  return {points, Falloff{0.1, 0.5, 1.0}, 0.5};
}

std::size_t
usedPoints(const Darn& darn)
{
  return darn.free_point.size() -
         static_cast<std::size_t>(
             std::count(darn.free_point.begin(), darn.free_point.end(), NONE));
}

TEST(DarningChoice, EachChoiceHasItsMethod)
{
  EXPECT_STREQ("fan", methodFor(DarningChoice::FAN)->name());
  EXPECT_STREQ("minimum weight", methodFor(DarningChoice::MINIMUM_WEIGHT)->name());
  EXPECT_STREQ("completion", methodFor(DarningChoice::COMPLETION)->name());
  EXPECT_STREQ("minimum weight", methodFor(DarningChoice::AUTOMATIC)->name());
}

TEST(DarningChoice, WhatIsSimpleIsForTheMethodToSay)
{
  for (const DarningChoice choice : {DarningChoice::FAN, DarningChoice::COMPLETION})
    EXPECT_EQ(methodFor(choice)->simpleEdges(), simpleEdges({choice, 0, 0}));
}

TEST(DarningChoice, WhatIsSimpleCanBeSaidByHand)
{
  EXPECT_EQ(17U, simpleEdges({DarningChoice::FAN, 17, 0}));
}

TEST(DarningChoice, FanClosesWithAPointInTheMiddle)
{
  const ChosenDarn made = darn(capHole(), DarningChoice::FAN, nullptr);
  EXPECT_STREQ("fan", made.method);
  EXPECT_TRUE(made.darn.closed());
  EXPECT_EQ(1U, made.darn.inner.size());
}

TEST(DarningChoice, MinimumWeightClosesWithoutANewPoint)
{
  const ChosenDarn made = darn(capHole(), DarningChoice::MINIMUM_WEIGHT, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.darn.closed());
  EXPECT_TRUE(made.darn.inner.empty());
}

TEST(DarningChoice, MinimumWeightTakesNoFreePoints)
{
  const FreePointField points = pointsOnTheCap(0.2);
  EXPECT_TRUE(
      darn(capHole(), DarningChoice::MINIMUM_WEIGHT, &points).darn.inner.empty());
}

TEST(DarningChoice, CompletionWithoutFreePointsIsMinimumWeight)
{
  const ChosenDarn made = darn(capHole(), DarningChoice::COMPLETION, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.darn.closed());
}

TEST(DarningChoice, CompletionTakesEvenAFewFreePoints)
{
  const FreePointField points = pointsOnTheCap(0.6);
  const ChosenDarn made = darn(capHole(), DarningChoice::COMPLETION, &points);
  EXPECT_STREQ("completion", made.method);
  EXPECT_GT(usedPoints(made.darn), 0U);
}

TEST(DarningChoice, AutomaticTakesFreePointsWhereThereAreEnough)
{
  const FreePointField points = pointsOnTheCap(0.2);
  const ChosenDarn made = darn(capHole(), DarningChoice::AUTOMATIC, &points);
  EXPECT_STREQ("completion", made.method);
  EXPECT_GT(usedPoints(made.darn), 30U);
}

TEST(DarningChoice, AutomaticTakesNoneWhereThereAreTooFew)
{
  const FreePointField points = pointsOnTheCap(0.6);
  const ChosenDarn made = darn(capHole(), DarningChoice::AUTOMATIC, &points);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.darn.inner.empty());
}

TEST(DarningChoice, PointsFarFromTheHoleAreNone)
{
  Positions far = pointsOnTheCap(0.2).points();
  for (Position& point : far)
    point.z() += 5.0;
  const FreePointField points(far, Falloff{0.1, 0.5, 1.0}, 0.5);
  EXPECT_STREQ("minimum weight",
               darn(capHole(), DarningChoice::COMPLETION, &points).method);
}

TEST(DarningChoice, FreePointsKeepTheirNumbersInTheField)
{
  Positions all(10, Position(9.0, 9.0, 9.0)); // far away, and first
  const Positions near = pointsOnTheCap(0.2).points();
  all.insert(all.end(), near.begin(), near.end());
  const FreePointField points(all, Falloff{0.1, 0.5, 1.0}, 0.5);
  const Darn made = darn(capHole(), DarningChoice::AUTOMATIC, &points).darn;
  ASSERT_GT(usedPoints(made), 0U);
  for (std::size_t v = 0; v < made.inner.size(); ++v) {
    if (made.free_point[v] != NONE) {
      EXPECT_EQ(all[made.free_point[v]], made.inner[v]);
    }
  }
}

/** Nothing may lie near the middle, where a fan has its new point. */
TEST(DarningChoice, WhereAFanIsInTheWayMinimumWeightIsTried)
{
  DarningTask task = holeIn(HoleShape{4, test::saddleHeight, 0.0});
  task.obstructed = [](const ccaa::Corners& corners) {
    const Position center(0.0, 0.0, 0.0);
    return std::any_of(corners.begin(), corners.end(), [&](const Position& corner) {
      return (corner - center).norm() < 0.1;
    });
  };
  const ChosenDarn made = darn(task, DarningChoice::FAN, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.darn.closed());
}

TEST(DarningChoice, WhereAllIsInTheWayThereIsNoDarn)
{
  for (const DarningChoice choice : {DarningChoice::FAN, DarningChoice::AUTOMATIC}) {
    DarningTask task = capHole();
    task.obstructed = [](const ccaa::Corners&) { return true; };
    EXPECT_FALSE(darn(task, choice, nullptr).darn.closed());
  }
}

} // namespace
} // namespace repair
} // namespace pcl
