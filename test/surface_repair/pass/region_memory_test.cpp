// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what is not tried again.

#include <gtest/gtest.h>

#include "pass/region_memory.h"

namespace pcl::repair {
namespace {

Region
squareRegion()
{
  Region region;
  region.holes.emplace_back();
  region.holes.front().curve.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  region.holes.front().vertices = {0, 1, 2, 3};
  region.is_certain = {false};
  return region;
}

RegionMemory::Key
keyOf(const Region& region)
{
  IncompleteModel model;
  model.free_points = {{0.5, 0.5, 0.1}};
  return RegionMemory::keyOf(region, model);
}

ccaa::Box
place()
{
  return {Position(-1, -1, -1), Position(2, 2, 1)};
}

std::vector<HoleOutcome>
outcomes(OpenReason reason)
{
  std::vector<HoleOutcome> holes(1);
  holes.front().open = reason;
  holes.front().tries = 3;
  return holes;
}

TEST(RegionMemory, KnowsHowARegionFailed)
{
  RegionMemory memory;
  EXPECT_EQ(nullptr, memory.find(keyOf(squareRegion())));
  memory.remember(keyOf(squareRegion()), {place(), outcomes(OpenReason::INTERSECTION)});
  const RegionMemory::Failure* found = memory.find(keyOf(squareRegion()));
  ASSERT_NE(nullptr, found);
  EXPECT_EQ(OpenReason::INTERSECTION, found->holes.front().open);
  EXPECT_EQ(3U, found->holes.front().tries);
}

TEST(RegionMemory, HolesOfWhichOneWasClosedHaveNotFailed)
{
  std::vector<HoleOutcome> holes = outcomes(OpenReason::INTERSECTION);
  EXPECT_TRUE(allFailed(holes));
  holes.push_back(outcomes(OpenReason::NONE).front());
  EXPECT_FALSE(allFailed(holes));
}

TEST(RegionMemory, TriesAgainWhereSomethingHasGone)
{
  RegionMemory memory;
  memory.remember(keyOf(squareRegion()), {place(), outcomes(OpenReason::INTERSECTION)});
  memory.forgetNear({{Position(5, 5, 5), Position(6, 6, 6)}, place()});
  EXPECT_EQ(nullptr, memory.find(keyOf(squareRegion())));
}

TEST(RegionMemory, DoesNotTryAgainWhereSomethingHasGoneElsewhere)
{
  RegionMemory memory;
  memory.remember(keyOf(squareRegion()), {place(), outcomes(OpenReason::INTERSECTION)});
  memory.forgetNear({{Position(5, 5, 5), Position(6, 6, 6)}});
  EXPECT_NE(nullptr, memory.find(keyOf(squareRegion())));
}

TEST(RegionMemory, TriesAgainARegionThatHasChanged)
{
  RegionMemory memory;
  memory.remember(keyOf(squareRegion()), {place(), outcomes(OpenReason::INTERSECTION)});
  Region moved = squareRegion();
  moved.holes.front().curve.points[2].z() = 1e-9;
  Region certain = squareRegion();
  certain.is_certain = {true};
  Region flat = squareRegion();
  flat.cap = Cap::FLAT;
  Region sampled = squareRegion();
  sampled.samples = {0};
  for (const Region& other : {moved, certain, flat, sampled})
    EXPECT_EQ(nullptr, memory.find(keyOf(other)));
}

} // namespace
} // namespace pcl::repair
