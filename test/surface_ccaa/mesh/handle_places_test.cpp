// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: through which parts of a surface its handles pass.
#include <gtest/gtest.h>

#include "mesh/handle_places.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace pcl::ccaa::test {
namespace {

using Flags = std::vector<std::uint8_t>;

Flags
flagged(const Shape& shape, const std::function<bool(const Position&)>& is_flagged)
{
  Flags flags;
  for (const Position& vertex : shape.vertices)
    flags.push_back(is_flagged(vertex) ? 1 : 0);
  return flags;
}

std::vector<pcl::index_t>
placesOf(const Shape& shape, const Flags& flags)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  std::vector<pcl::index_t> places;
  for (const HandlePlace& place : handlePlaces(shape.triangles, adjacency, flags))
    places.push_back(place.flagged);
  return places;
}

double
fromAxis(const Position& position)
{
  return std::hypot(position.x(), position.y());
}

bool
isAtSideX(const Position& position)
{
  return position.x() > 0.0 && std::abs(position.y()) < 0.1;
}

TEST(HandlePlaces, ABandAroundATubeIsToldByItsLowestVertex)
{
  const Shape ring = torus(40, 20);
  const Flags flags = flagged(ring, isAtSideX);
  const auto lowest = std::find(flags.begin(), flags.end(), 1) - flags.begin();
  EXPECT_EQ(std::vector<pcl::index_t>{static_cast<pcl::index_t>(lowest)},
            placesOf(ring, flags));
}

TEST(HandlePlaces, ABandThatDividesABodyHasNone)
{
  const Shape ball = icosphere(3);
  EXPECT_TRUE(
      placesOf(ball,
               flagged(ball, [](const Position& p) { return std::abs(p.z()) < 0.1; }))
          .empty());
}

TEST(HandlePlaces, OfTheRimOfAPlateAndATunnelThroughItTheTunnelIsTold)
{
  const Shape plate = torus(40, 20);
  const auto isTunnel = [](const Position& p) { return fromAxis(p) < 0.66; };
  const auto places = placesOf(plate, flagged(plate, [&](const Position& p) {
                                 return isTunnel(p) || fromAxis(p) > 1.28;
                               }));
  ASSERT_EQ(1U, places.size());
  EXPECT_TRUE(isTunnel(plate.vertices[static_cast<std::size_t>(places.front())]));
}

TEST(HandlePlaces, APartMayHaveAHandleOfItsOwn)
{
  const Shape ring = torus(40, 20);
  const auto isElsewhere = [](const Position& p) {
    return !isAtSideX(p) || p.z() < 0.2;
  };
  EXPECT_EQ(1U, placesOf(ring, flagged(ring, isElsewhere)).size());
  EXPECT_EQ(1U, placesOf(ring, Flags(ring.vertices.size(), 1)).size());
}

TEST(HandlePlaces, ADiscBesideAHandleHasNone)
{
  const Shape ring = torus(40, 20);
  const auto isCap = [](const Position& p) { return isAtSideX(p) && p.z() > 0.2; };
  EXPECT_TRUE(placesOf(ring, flagged(ring, isCap)).empty());
}

TEST(HandlePlaces, AnOpenTubeHasNone)
{
  const Shape tube = cylinder(12, 8);
  EXPECT_TRUE(placesOf(tube, Flags(tube.vertices.size(), 1)).empty());
  const auto isMiddle = [](const Position& p) { return std::abs(p.z()) < 0.4; };
  EXPECT_TRUE(placesOf(tube, flagged(tube, isMiddle)).empty());
}

TEST(HandlePlaces, EachOfTwoBodiesHasItsOwn)
{
  const Shape ring = torus(40, 20);
  const Shape pair = joined(ring, translated(ring, {0.0, 5.0, 0.0}));
  const auto isAtSide = [](const Position& p) {
    return isAtSideX(p) || isAtSideX(p - Position(0.0, 5.0, 0.0));
  };
  EXPECT_EQ(2U, placesOf(pair, flagged(pair, isAtSide)).size());
}

/** However parts touch themselves and each other. */
TEST(HandlePlaces, AreNeverMoreThanTheSurfaceHasHandles)
{
  std::mt19937 random(1);
  const Shape ball = icosphere(3), ring = torus(40, 20);
  for (int round = 0; round < 200; ++round) {
    std::bernoulli_distribution is_chosen(0.005 * (round % 40));
    const auto chosen = [&](const Position&) { return is_chosen(random); };
    EXPECT_TRUE(placesOf(ball, flagged(ball, chosen)).empty()) << round;
    EXPECT_GE(1U, placesOf(ring, flagged(ring, chosen)).size()) << round;
  }
}

} // namespace
} // namespace pcl::ccaa::test
