// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which filling method closes a hole.

#include <gtest/gtest.h>

#include "region/filling_choice.h"
#include "surface_repair/filling/filling_samples.h"

#include <algorithm>
#include <string>

namespace pcl::repair {
namespace {

using test::capHeight;
using test::holeIn;
using test::HoleShape;

FillingTask
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
usedPoints(const Filling& filling)
{
  return filling.free_point.size() -
         static_cast<std::size_t>(
             std::count(filling.free_point.begin(), filling.free_point.end(), NONE));
}

TEST(FillingChoice, EachChoiceHasItsMethod)
{
  EXPECT_STREQ("fan", methodFor(FillingChoice::FAN)->name());
  EXPECT_STREQ("minimum weight", methodFor(FillingChoice::MINIMUM_WEIGHT)->name());
  EXPECT_STREQ("completion", methodFor(FillingChoice::COMPLETION)->name());
  EXPECT_STREQ("minimum weight", methodFor(FillingChoice::AUTOMATIC)->name());
}

TEST(FillingChoice, WhatIsSimpleIsForTheMethodToSay)
{
  for (const FillingChoice choice : {FillingChoice::FAN, FillingChoice::COMPLETION})
    EXPECT_EQ(methodFor(choice)->simpleEdges(), simpleEdges({choice, 0, 0}));
}

TEST(FillingChoice, WhatIsSimpleCanBeSaidByHand)
{
  EXPECT_EQ(17U, simpleEdges({FillingChoice::FAN, 17, 0}));
}

TEST(FillingChoice, FanClosesWithAPointInTheMiddle)
{
  const ChosenFilling made = fillHole(capHole(), FillingChoice::FAN, nullptr);
  EXPECT_STREQ("fan", made.method);
  EXPECT_TRUE(made.filling.closed());
  EXPECT_EQ(1U, made.filling.inner.size());
}

TEST(FillingChoice, MinimumWeightClosesWithoutANewPoint)
{
  const ChosenFilling made =
      fillHole(capHole(), FillingChoice::MINIMUM_WEIGHT, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.filling.closed());
  EXPECT_TRUE(made.filling.inner.empty());
}

TEST(FillingChoice, MinimumWeightTakesNoFreePoints)
{
  const FreePointField points = pointsOnTheCap(0.2);
  EXPECT_TRUE(fillHole(capHole(), FillingChoice::MINIMUM_WEIGHT, &points)
                  .filling.inner.empty());
}

TEST(FillingChoice, CompletionWithoutFreePointsIsMinimumWeight)
{
  const ChosenFilling made = fillHole(capHole(), FillingChoice::COMPLETION, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.filling.closed());
}

TEST(FillingChoice, CompletionTakesEvenAFewFreePoints)
{
  const FreePointField points = pointsOnTheCap(0.6);
  const ChosenFilling made = fillHole(capHole(), FillingChoice::COMPLETION, &points);
  EXPECT_STREQ("completion", made.method);
  EXPECT_GT(usedPoints(made.filling), 0U);
}

TEST(FillingChoice, AutomaticTakesFreePointsWhereThereAreEnough)
{
  const FreePointField points = pointsOnTheCap(0.2);
  const ChosenFilling made = fillHole(capHole(), FillingChoice::AUTOMATIC, &points);
  EXPECT_STREQ("completion", made.method);
  EXPECT_GT(usedPoints(made.filling), 30U);
}

TEST(FillingChoice, AutomaticTakesNoneWhereThereAreTooFew)
{
  const FreePointField points = pointsOnTheCap(0.6);
  const ChosenFilling made = fillHole(capHole(), FillingChoice::AUTOMATIC, &points);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.filling.inner.empty());
}

TEST(FillingChoice, PointsFarFromTheHoleAreNone)
{
  Positions far = pointsOnTheCap(0.2).points();
  for (Position& point : far)
    point.z() += 5.0;
  const FreePointField points(far, Falloff{0.1, 0.5, 1.0}, 0.5);
  EXPECT_STREQ("minimum weight",
               fillHole(capHole(), FillingChoice::COMPLETION, &points).method);
}

TEST(FillingChoice, FreePointsKeepTheirNumbersInTheField)
{
  Positions all(10, Position(9.0, 9.0, 9.0)); // far away, and first
  const Positions near = pointsOnTheCap(0.2).points();
  all.insert(all.end(), near.begin(), near.end());
  const FreePointField points(all, Falloff{0.1, 0.5, 1.0}, 0.5);
  const Filling made = fillHole(capHole(), FillingChoice::AUTOMATIC, &points).filling;
  ASSERT_GT(usedPoints(made), 0U);
  for (std::size_t v = 0; v < made.inner.size(); ++v) {
    if (made.free_point[v] != NONE) {
      EXPECT_EQ(all[made.free_point[v]], made.inner[v]);
    }
  }
}

/** Nothing may lie near the middle, where a fan has its new point. */
TEST(FillingChoice, WhereAFanIsInTheWayMinimumWeightIsTried)
{
  FillingTask task = holeIn(HoleShape{4, test::saddleHeight, 0.0});
  task.obstructed = [](const ccaa::Corners& corners) {
    const Position center(0.0, 0.0, 0.0);
    return std::any_of(corners.begin(), corners.end(), [&](const Position& corner) {
      return (corner - center).norm() < 0.1;
    });
  };
  const ChosenFilling made = fillHole(task, FillingChoice::FAN, nullptr);
  EXPECT_STREQ("minimum weight", made.method);
  EXPECT_TRUE(made.filling.closed());
}

TEST(FillingChoice, WhereAllIsInTheWayThereIsNoFilling)
{
  for (const FillingChoice choice : {FillingChoice::FAN, FillingChoice::AUTOMATIC}) {
    FillingTask task = capHole();
    task.obstructed = [](const ccaa::Corners&) { return true; };
    EXPECT_FALSE(fillHole(task, choice, nullptr).filling.closed());
  }
}

} // namespace
} // namespace pcl::repair
