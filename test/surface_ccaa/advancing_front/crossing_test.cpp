// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of triangles against the surface around them.
#include <gtest/gtest.h>

#include "advancing_front/nearby_triangles.h"
#include "advancing_front/triangle_trial.h"
#include "completion_helpers.h"
#include "mesh/intersection.h"
#include "open_shapes.h"

#include <algorithm>

namespace pcl::ccaa::test {
namespace {

bool
meetsAny(const Positions& positions, const Triangles& triangles, const Triangle& t)
{
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& other) {
    return trianglesMeet(cornersOf(t, positions), cornersOf(other, positions));
  });
}

/** A rough terrain in tatters: many open points, triangles at all angles. */
Shape
tatters(std::uint64_t seed)
{
  Shape shape = withoutRandomTriangles(grid(14, 14), 0.4, seed);
  RandomSource random(seed);
  for (Position& vertex : shape.vertices)
    for (double& coordinate : vertex.reshaped())
      coordinate += random.uniform(-0.3, 0.3);
  return filteredToIcadm(roundedToFloat(shape), 0);
}

TEST(TriangleTrial, CrossesWhatAnyTriangleOfTheSurfaceMeets)
{
  std::size_t crossing = 0, free = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const OpenSurface open = openSurfaceOf(tatters(seed));
    const GrowingSurface surface(open);
    TriangleTrial trial(open, surface, 2.0, nullptr);
    RandomSource random(seed);
    for (int round = 0; round < 1500; ++round) {
      const auto a = static_cast<index_t>(random.below(open.open_points));
      const index_t* near = open.neighbors.row(a);
      const Triangle t{a, near[random.below(6)], near[random.below(6)]};
      if (t[1] == t[2])
        continue;
      const bool expected = meetsAny(open.positions, surface.triangles(), t);
      ASSERT_EQ(trial.crossesSurface(t), expected) << seed << " " << round;
      (expected ? crossing : free) += 1;
    }
  }
  EXPECT_GT(crossing, 500u);
  EXPECT_GT(free, 500u);
}

TEST(TriangleTrial, ATriangleWithoutAreaCrosses)
{
  const OpenSurface open = openPoints({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1, 0}});
  const GrowingSurface surface(open);
  TriangleTrial trial(open, surface, 2.0, nullptr);
  EXPECT_TRUE(trial.crossesSurface({0, 1, 2}));
  EXPECT_FALSE(trial.crossesSurface({0, 1, 3}));
}

TEST(TriangleTrial, SeesTrianglesMadeSinceItBegan)
{
  const OpenSurface open = openPoints(
      {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0.1}, {0.5, 0, 5}});
  GrowingSurface surface(open);
  TriangleTrial trial(open, surface, 2.0, nullptr);
  EXPECT_FALSE(trial.crossesSurface({3, 4, 5}));
  surface.addTriangle({0, 1, 2});
  EXPECT_TRUE(trial.crossesSurface({3, 4, 5}));
}

TEST(TriangleTrial, SupportsUpToTheGivenMultipleOfTheSpacing)
{
  Positions points = grid(9, 9).vertices;
  points.emplace_back(4.0, 4.0, 50.0);
  const OpenSurface open = openPoints(points);
  const GrowingSurface surface(open);
  for (const double support : {1.0, 2.0, 3.0}) {
    const TriangleTrial trial(open, surface, support, nullptr);
    EXPECT_TRUE(trial.isSupported(Triangle{40, 41, 50})); // two halves of a square
    EXPECT_FALSE(trial.isSupported(Triangle{0, 8, 80}));  // half of all
  }
}

/** A sphere with holes, its open vertices, and a cell as wide as three edges. */
struct HoledSphere {
  HoledSphere() : partial(withoutPatches(icosphere(4), 4, 1, 11)) {}

  PartialShape partial;
  std::vector<index_t> open = partial.openVertices();
};

/** A triangle between an open vertex and places close to it. */
Corners
smallTriangleAt(const Position& place, RandomSource& random)
{
  Corners corners{place, place, place};
  for (std::size_t i = 1; i < 3; ++i)
    for (double& coordinate : corners[i].reshaped())
      coordinate += random.uniform(-0.15, 0.15);
  return corners;
}

TEST(NearbyTriangles, AreMetWhereAnyLiveTriangleIsMet)
{
  HoledSphere sphere;
  AliveFlags alive(sphere.partial.shape.triangles.size(), 1);
  const NearbyTriangles nearby(sphere.partial.shape.triangles,
                               alive,
                               sphere.partial.shape.vertices,
                               sphere.open,
                               0.25);
  RandomSource random(2);
  for (std::size_t t = 0; t < alive.size(); ++t)
    alive[t] = random.uniform() < 0.5; // they may die after the choice
  std::size_t meetings = 0;
  const Positions& positions = sphere.partial.shape.vertices;
  for (int round = 0; round < 600; ++round) {
    const index_t at = sphere.open[random.below(sphere.open.size())];
    const Corners corners = smallTriangleAt(positions[std::size_t(at)], random);
    bool expected = false;
    for (std::size_t t = 0; t < alive.size(); ++t)
      expected =
          expected ||
          (alive[t] != 0 &&
           trianglesMeet(corners,
                         cornersOf(sphere.partial.shape.triangles[t], positions)));
    ASSERT_EQ(nearby.meets(corners, {}), expected) << round;
    meetings += expected;
  }
  EXPECT_GT(meetings, 100u);
  EXPECT_LT(meetings, 500u);
}

TEST(NearbyTriangles, AreNotMetWhenTheyAreToBeIgnored)
{
  const Triangles wall{{0, 1, 2}};
  const AliveFlags alive{1};
  const Positions points{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
  const NearbyTriangles nearby(wall, alive, points, {0, 1, 2}, 2.0);
  const Corners corners{Position(0, -1, 0), Position(0, 1, 0), Position(0.5, 0, 5)};
  EXPECT_TRUE(nearby.meets(corners, {}));
  EXPECT_FALSE(nearby.meets(corners, {0}));
}

/** Two of them that run through each other. */
Shape
twoTatters(std::uint64_t seed)
{
  return joined(tatters(2 * seed), translated(tatters(2 * seed + 1), {0.3, 0.2, 0.1}));
}

TEST(NearbyTriangles, ThatCrossOthersAreThoseThatMeetAnyOfAll)
{
  std::size_t crossing = 0, free = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const PartialShape partial(twoTatters(seed));
    const Triangles& all = partial.shape.triangles;
    const std::vector<index_t> open = partial.openVertices();
    const AliveFlags alive(all.size(), 1);
    const NearbyTriangles nearby(all, alive, partial.shape.vertices, open, 4.0);
    std::vector<index_t> expected;
    for (std::size_t t = 0; t < all.size(); ++t) {
      Triangles others = all;
      others.erase(others.begin() + std::ptrdiff_t(t));
      const bool is_open = std::any_of(all[t].begin(), all[t].end(), [&](index_t v) {
        return std::binary_search(open.begin(), open.end(), v);
      });
      if (is_open && meetsAny(partial.shape.vertices, others, all[t]))
        expected.push_back(index_t(t));
    }
    for (const int threads : {1, 3})
      EXPECT_EQ(nearby.crossingAt(open, partial.shape.vertices.size(), {threads}),
                expected);
    crossing += expected.size();
    free += all.size() - expected.size();
  }
  EXPECT_GT(crossing, 0u);
  EXPECT_GT(free, 100u);
}

TEST_F(CompletionTest, GivenTrianglesThatCrossAreMadeAnew)
{
  completion_.setKeepGiven(false);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Shape given = twoTatters(seed);
    RunControl control;
    EXPECT_TRUE(findSelfIntersections(complete(given), given.vertices, 1, control)
                    .pairs.empty())
        << seed;
  }
}

TEST(NearbyTriangles, AreFewerThanAll)
{
  HoledSphere sphere;
  const NearbyTriangles nearby(sphere.partial.shape.triangles,
                               sphere.partial.surface.aliveGiven(),
                               sphere.partial.shape.vertices,
                               sphere.open,
                               0.25);
  EXPECT_GT(nearby.size(), 0u);
  EXPECT_LT(nearby.size(), sphere.partial.shape.triangles.size() * 3 / 4);
}

TEST(NearbyTriangles, OfNothingAreNone)
{
  const Triangles none;
  const AliveFlags alive;
  const Positions points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const NearbyTriangles nearby(none, alive, points, {0, 1, 2}, 1.0);
  EXPECT_EQ(nearby.size(), 0u);
  const Corners corners{points[0], points[1], points[2]};
  EXPECT_FALSE(nearby.meets(corners, {}));
}

/** No corner is open, but the surface folds where it crosses itself. */
TEST_F(CompletionTest, CrossingsOfAClosedSurfaceAreMadeAnew)
{
  completion_.setKeepGiven(false);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Shape given = icosphere(3);
    RandomSource random(seed);
    for (Position& vertex : given.vertices)
      for (double& coordinate : vertex.reshaped())
        coordinate += random.uniform(-0.12, 0.12);
    given = roundedToFloat(given);
    RunControl control;
    ASSERT_FALSE(findSelfIntersections(given.triangles, given.vertices, 1, control)
                     .pairs.empty());
    EXPECT_TRUE(findSelfIntersections(complete(given), given.vertices, 1, control)
                    .pairs.empty())
        << seed;
  }
}

} // namespace
} // namespace pcl::ccaa::test
