// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of cutting space into parts of as many points.
#include <gtest/gtest.h>

#include "support/random_source.h"
#include "tiles/bisection.h"
#include "tiles/world_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** On a rough surface, one half of it ten times as dense as the other. */
Positions
roughSurface(RandomSource& random, std::size_t count)
{
  Positions places;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0.0, 0.5) + (i % 11 == 0 ? 0.5 : 0.0);
    const double y = random.uniform();
    places.emplace_back(x, y, 0.2 * std::sin(9.0 * x) * y + random.uniform(0.0, 0.05));
  }
  return places;
}

/** The leaves of an octree that hold at most so many of them. */
std::vector<CountedBox>
leavesOf(const Positions& all, std::size_t most)
{
  std::vector<CountedBox> leaves;
  std::vector<std::pair<GridCell, Positions>> open{{GridCell(), all}};
  while (!open.empty()) {
    const auto [cell, places] = open.back();
    open.pop_back();
    std::map<GridCell, Positions> children;
    CountedBox leaf;
    for (const Position& place : places) {
      children[childOf(cell, place)].push_back(place);
      leaf.box.extend(place);
    }
    leaf.count = double(places.size());
    if (places.size() <= most)
      leaves.push_back(leaf);
    else
      open.insert(open.end(), children.begin(), children.end());
  }
  return leaves;
}

std::vector<std::size_t>
countsIn(const std::vector<Box>& parts, const Positions& places)
{
  std::vector<std::size_t> counts(parts.size(), 0);
  for (const Position& place : places)
    for (std::size_t i = 0; i < parts.size(); ++i)
      counts[i] += holds(parts[i], place) ? 1 : 0;
  return counts;
}

TEST(Bisection, GivesEachPointToOnePartAndEachPartItsShare)
{
  RandomSource random(5);
  const Positions places = roughSurface(random, 30000);
  for (const std::size_t each : {1500U, 4000U, 10000U, 30000U}) {
    const std::vector<Box> parts = bisect(leavesOf(places, each / 8), each);
    ASSERT_EQ(parts.size(), (30000 + each - 1) / each);
    std::size_t sum = 0;
    for (const std::size_t count : countsIn(parts, places)) {
      EXPECT_NEAR(double(count), 30000.0 / double(parts.size()), 0.1 * double(each));
      sum += count;
    }
    EXPECT_EQ(sum, places.size());
  }
}

TEST(Bisection, CutsEvenPointsAcrossTheLongestAxis)
{
  RandomSource random(6);
  Positions places;
  for (int i = 0; i < 4000; ++i)
    places.emplace_back(
        random.uniform(), random.uniform(0.0, 8.0), random.uniform(0.0, 0.1));
  const std::vector<Box> parts = bisect(leavesOf(places, 100), 1000);
  ASSERT_EQ(parts.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(std::isinf(parts[i].min().x()) && std::isinf(parts[i].max().z()));
    if (i > 0) {
      EXPECT_EQ(parts[i - 1].max().y(), parts[i].min().y());
      EXPECT_NEAR(parts[i].min().y(), 2.0 * double(i), 0.2);
    }
  }
}

TEST(Bisection, CutsWhereTheFewestPointsLie)
{
  RandomSource random(7);
  Positions places; // two strips that are hardly connected, longer than their distance
  for (int i = 0; i < 4000; ++i)
    places.emplace_back(random.uniform(0.0, 5.0),
                        random.uniform() + (i % 2 == 0 ? 3.0 : 0.0),
                        random.uniform(0.0, 0.1));
  for (int i = 0; i < 20; ++i)
    places.emplace_back(2.5, random.uniform(1.0, 3.0), 0.0);
  const std::vector<Box> parts = bisect(leavesOf(places, 100), 2010);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_TRUE(std::isinf(parts[1].min().x()));
  EXPECT_NEAR(parts[1].min().y(), 2.0, 1.0);
}

TEST(Bisection, DoesNotCutWhatLiesInOnePlace)
{
  for (const double place : {0.0, 3.0, 7.0}) {
    Positions places(1000, Position(place, 2.0, 5.0));
    std::vector<CountedBox> boxes{{Box(places[0]), 1000.0}};
    for (const double x : {0.0, 1.0, 5.0, 7.0})
      if (x != place) {
        places.emplace_back(x, 2.0, 5.0);
        boxes.push_back({Box(places.back()), 1.0});
      }
    const std::vector<std::size_t> counts = countsIn(bisect(boxes, 10), places);
    EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 1000U);
    for (const std::size_t count : counts)
      EXPECT_GE(count, 1U);
  }
}

TEST(Bisection, OfNothingIsNothing) { EXPECT_TRUE(bisect({}, 10).empty()); }

TEST(Bisection, OfWhatNeedsNoCutIsAllOfSpace)
{
  const auto parts = bisect({{Box(Position(1.0, 2.0, 3.0)), 5.0}}, 5);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(holds(parts[0], Position(-1e300, 1e300, 0.0)));
}

} // namespace
} // namespace pcl::ccaa::test
