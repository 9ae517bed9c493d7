// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what new triangles must not run through.

#include <gtest/gtest.h>

#include "mesh/intersection.h"
#include "patch/surface_obstacle.h"
#include "support/random_source.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <set>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;

ccaa::Box
everywhere()
{
  return {Position::Constant(-100.0), Position::Constant(100.0)};
}

/** Triangles of a size with their first corners in a cube of side 1. */
Shape
randomTriangles(std::size_t count, double size, std::uint64_t seed)
{
  RandomSource random(seed);
  const auto place = [&](double reach) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
    return Position(x, y, random.uniform(-reach, reach));
  };
  Shape shape;
  for (std::size_t t = 0; t < count; ++t) {
    const auto first = static_cast<pcl::index_t>(shape.vertices.size());
    const Position corner = place(0.5);
    shape.vertices.push_back(corner);
    for (int k = 0; k < 2; ++k)
      shape.vertices.push_back(corner + place(size));
    shape.triangles.push_back({first, first + 1, first + 2});
  }
  return shape;
}

Patch
patchOf(const Shape& shape)
{
  Patch patch;
  patch.positions = shape.vertices;
  patch.triangles = shape.triangles;
  patch.free_point.assign(shape.vertices.size(), NONE);
  patch.hole.assign(shape.triangles.size(), 0);
  return patch;
}

/** Triangles of the second shape that meet one of either, by findSelfIntersections().
 */
std::vector<std::size_t>
meetingByTheLibrary(const Shape& surface, const Shape& patch)
{
  const Shape both = joined(surface, patch);
  ccaa::RunControl control;
  std::set<std::size_t> meeting;
  for (const auto& [a, b] :
       ccaa::findSelfIntersections(both.triangles, both.vertices, 1, control).pairs)
    for (const pcl::index_t t : {a, b})
      if (static_cast<std::size_t>(t) >= surface.triangles.size())
        meeting.insert(static_cast<std::size_t>(t) - surface.triangles.size());
  return {meeting.begin(), meeting.end()};
}

class RandomObstacles : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomObstacles, AreFoundAsByTheSearchForSelfIntersections)
{
  const Shape surface = randomTriangles(60, 0.2, GetParam());
  const Shape patch = randomTriangles(60, 0.2, GetParam() + 1000);
  const SurfaceObstacle obstacle(modelOf(surface), {everywhere()});
  EXPECT_EQ(meetingByTheLibrary(surface, patch),
            obstructedTriangles(patchOf(patch), obstacle));
}

TEST_P(RandomObstacles, AreTheSameInLayers)
{
  const Shape surface = randomTriangles(60, 0.2, GetParam());
  SurfaceObstacle layers(modelOf(icosphere(0, 0.001)), {everywhere()});
  for (std::size_t t = 0; t < surface.triangles.size(); t += 20)
    layers.add(surface.vertices,
               {surface.triangles.begin() + static_cast<std::ptrdiff_t>(t),
                surface.triangles.begin() + static_cast<std::ptrdiff_t>(t) + 20});
  const SurfaceObstacle whole(modelOf(surface), {everywhere()});
  const Shape asked =
      translated(randomTriangles(200, 0.1, GetParam() + 2000), {0.1, 0, 0});
  for (const Triangle& triangle : asked.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, asked.vertices);
    if (corners[0].norm() > 0.3) { // beyond the small sphere's reach
      EXPECT_EQ(whole.meets(corners), layers.meets(corners));
    }
  }
}

TEST_P(RandomObstacles, AreTheSameNearThePlacesOnly)
{
  const Shape surface = randomTriangles(60, 0.2, GetParam());
  const Shape asked = scaled(randomTriangles(100, 0.3, GetParam() + 3000), 0.2);
  ccaa::Box box;
  for (const Position& vertex : asked.vertices)
    box.extend(vertex);
  const SurfaceObstacle near(modelOf(surface), {box});
  const SurfaceObstacle whole(modelOf(surface), {everywhere()});
  for (const Triangle& triangle : asked.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, asked.vertices);
    EXPECT_EQ(whole.meets(corners), near.meets(corners));
  }
}

TEST_P(RandomObstacles, ThatAWayCrossesAreMetByAllTrianglesWithIt)
{
  const SurfaceObstacle obstacle(modelOf(randomTriangles(60, 0.2, GetParam())),
                                 {everywhere()});
  std::size_t crossed = 0;
  const Shape asked = randomTriangles(400, 0.5, GetParam() + 4000);
  for (const Triangle& triangle : asked.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, asked.vertices);
    if (obstacle.isCrossedBy(corners[0], corners[1])) {
      ++crossed;
      EXPECT_TRUE(obstacle.meets(corners));
    }
  }
  EXPECT_GT(crossed, 10U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomObstacles, ::testing::Range(0U, 10U));

/** Three corners at equal heights around the z axis. */
ccaa::Corners
levelTriangle(double z, double radius = 0.3)
{
  return {Position(radius, 0.0, z),
          Position(-0.5 * radius, 0.8 * radius, z),
          Position(-0.5 * radius, -0.8 * radius, z)};
}

const Shape LEVEL{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(SurfaceObstacle, IsCrossedByWaysThatTouchIt)
{
  const SurfaceObstacle obstacle(modelOf(LEVEL), {everywhere()});
  EXPECT_TRUE(obstacle.isCrossedBy({0.2, 0.2, 1.0}, {0.2, 0.2, -1.0}));
  EXPECT_TRUE(obstacle.isCrossedBy({0.2, 0.2, 1.0}, {0.2, 0.2, 0.0}));
  EXPECT_TRUE(obstacle.isCrossedBy({0.5, 0.0, 1.0}, {0.5, 0.0, -1.0}));
  EXPECT_TRUE(obstacle.isCrossedBy({-1.0, 0.2, 0.0}, {2.0, 0.2, 0.0}));
  EXPECT_FALSE(obstacle.isCrossedBy({0.6, 0.6, 1.0}, {0.6, 0.6, -1.0}));
}

TEST(SurfaceObstacle, IsCrossedByWaysFromItsCornersThatRunWithinIt)
{
  const SurfaceObstacle obstacle(modelOf(LEVEL), {everywhere()});
  EXPECT_TRUE(obstacle.isCrossedBy({0, 0, 0}, {1, 1, 0}));
  EXPECT_TRUE(obstacle.isCrossedBy({0.1, 0.2, 0}, {1, 0, 0}));
  EXPECT_FALSE(obstacle.isCrossedBy({0, 0, 0}, {-1, -1, 0}));
  EXPECT_FALSE(obstacle.isCrossedBy({0, 0, 0}, {1, 1, 1}));
  EXPECT_FALSE(obstacle.isCrossedBy({0, 0, 0}, {1, 0, 0}));
}

/** On a small lattice many corners are common, and many triangles in one plane. */
TEST(SurfaceObstacle, ThatALatticeWayCrossesIsMetByAllTrianglesWithIt)
{
  RandomSource random(5);
  const auto corners = [&] {
    Positions places;
    for (int k = 0; k < 3; ++k) {
      const auto x = static_cast<double>(random.below(4));
      const auto y = static_cast<double>(random.below(4));
      places.emplace_back(x, y, static_cast<double>(random.below(2)));
    }
    return ccaa::Corners{places[0], places[1], places[2]};
  };
  std::size_t crossed = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const ccaa::Corners there = corners(), asked = corners();
    if (ccaa::isCollinear(there) || ccaa::isCollinear(asked))
      continue;
    SurfaceObstacle obstacle(IncompleteModel(), {});
    obstacle.add({there[0], there[1], there[2]}, {{0, 1, 2}});
    if (!obstacle.isCrossedBy(asked[0], asked[1]))
      continue;
    ++crossed;
    EXPECT_TRUE(obstacle.meets(asked)) << trial;
  }
  EXPECT_GT(crossed, 2000U);
}

TEST(SurfaceObstacle, IsMetByATriangleThroughIt)
{
  const SurfaceObstacle sphere(modelOf(icosphere(3)), {everywhere()});
  EXPECT_TRUE(sphere.meets(levelTriangle(0.0, 3.0)));
}

TEST(SurfaceObstacle, IsNotMetInsideOrOutside)
{
  const SurfaceObstacle sphere(modelOf(icosphere(3)), {everywhere()});
  EXPECT_FALSE(sphere.meets(levelTriangle(0.5)));
  EXPECT_FALSE(sphere.meets(levelTriangle(1.5)));
}

TEST(SurfaceObstacle, IsNotMetByANeighbourOverACommonEdge)
{
  const Shape sheet = grid(2, 2);
  const SurfaceObstacle obstacle(modelOf(sheet), {everywhere()});
  EXPECT_FALSE(obstacle.meets(
      {Position(0.0, 0.0, 0.0), Position(1.0, 0.0, 0.0), Position(0.5, -1.0, 0.2)}));
}

TEST(SurfaceObstacle, IsMetByATriangleFoldedOntoIt)
{
  const SurfaceObstacle obstacle(modelOf(grid(2, 2)), {everywhere()});
  EXPECT_TRUE(obstacle.meets(
      {Position(1.0, 0.0, 0.0), Position(0.0, 0.0, 0.0), Position(0.4, 0.3, 0.0)}));
}

TEST(SurfaceObstacle, ATriangleWithoutAreaMeetsNothing)
{
  const SurfaceObstacle sphere(modelOf(icosphere(2)), {everywhere()});
  EXPECT_FALSE(sphere.meets(
      {Position(-2.0, 0.0, 0.0), Position(0.0, 0.0, 0.0), Position(2.0, 0.0, 0.0)}));
}

TEST(SurfaceObstacle, ItsOwnTrianglesWithoutAreaAreMetByNothing)
{
  SurfaceObstacle obstacle(modelOf(translated(tetrahedron(), {9.0, 9.0, 9.0})),
                           {everywhere()});
  obstacle.add(
      {Position(0.0, 0.0, -1.0), Position(0.0, 0.0, 0.0), Position(0.0, 0.0, 1.0)},
      {{0, 1, 2}});
  EXPECT_FALSE(obstacle.meets(levelTriangle(0.0)));
}

TEST(SurfaceObstacle, IsMetByTheSameTrianglesAndSeenTheSameIfAskedAfterThoseMetLast)
{
  const Shape surface = randomTriangles(60, 0.3, 5);
  const Shape asked = randomTriangles(300, 0.3, 6);
  const SurfaceObstacle obstacle(modelOf(surface), {everywhere()});
  ccaa::Box seen, seen_after_last;
  LastMet last;
  std::size_t met = 0;
  for (const Triangle& triangle : asked.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, asked.vertices);
    const bool meets = obstacle.watched(seen).meets(corners);
    EXPECT_EQ(obstacle.watched(seen_after_last).meets(corners, nullptr, &last), meets);
    met += meets;
  }
  EXPECT_GT(met, 50u);
  EXPECT_LT(met, 250u);
  EXPECT_TRUE(seen_after_last.isApprox(seen));
}

TEST(SurfaceObstacle, WhatIsAddedIsThereFromThenOn)
{
  SurfaceObstacle obstacle(modelOf(icosphere(2)), {everywhere()});
  EXPECT_FALSE(obstacle.meets(levelTriangle(3.0)));
  const Shape far = translated(icosphere(1, 0.1), {0.0, 0.0, 3.0});
  obstacle.add(far.vertices, far.triangles);
  EXPECT_TRUE(obstacle.meets(levelTriangle(3.0)));
}

TEST(SurfaceObstacle, AddingNothingChangesNothing)
{
  SurfaceObstacle obstacle(modelOf(icosphere(2)), {everywhere()});
  obstacle.add({}, {});
  EXPECT_TRUE(obstacle.meets(levelTriangle(0.0, 3.0)));
  EXPECT_FALSE(obstacle.meets(levelTriangle(0.0)));
}

TEST(SurfaceObstacle, WithoutPlacesNothingIsInTheWay)
{
  const SurfaceObstacle obstacle(modelOf(icosphere(2)), {});
  EXPECT_FALSE(obstacle.meets(levelTriangle(0.0, 3.0)));
}

TEST(ObstructedTriangles, ThoseThatRunThroughEachOtherAreBothFound)
{
  const SurfaceObstacle obstacle(modelOf(icosphere(1, 0.01)), {});
  Shape shape;
  for (const ccaa::Corners& corners : {levelTriangle(0.0),
                                       levelTriangle(2.0),
                                       ccaa::Corners{Position(0.0, 0.0, -1.0),
                                                     Position(0.0, 0.0, 1.0),
                                                     Position(5.0, 0.0, 0.1)}})
    shape.vertices.insert(shape.vertices.end(), corners.begin(), corners.end());
  shape.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  const std::vector<std::size_t> found = obstructedTriangles(patchOf(shape), obstacle);
  EXPECT_EQ((std::vector<std::size_t>{0, 2}), found);
}

TEST(ObstructedTriangles, OfThoseWithoutAnAreaTheOnesThatANewVertexMakes)
{
  const SurfaceObstacle obstacle(modelOf(icosphere(1, 0.01)), {});
  Shape shape;
  shape.vertices = {{1, 1, 5}, {2, 1, 5}, {3, 1, 5}, {1, 1, 5}, {2, 1, 5}};
  shape.triangles = {{0, 1, 2}, {0, 3, 1}, {4, 2, 1}};
  Patch patch = patchOf(shape);
  patch.rim = {0, 1, 2, 3};
  EXPECT_EQ((std::vector<std::size_t>{2}), obstructedTriangles(patch, obstacle));
}

TEST(ObstructedTriangles, APatchBesideTheSurfaceHasNone)
{
  const Shape sphere = icosphere(3);
  const Shape surface =
      test::without(sphere, [](const Position& p) { return p.z() > 0.7; });
  const Shape cap =
      test::without(sphere, [](const Position& p) { return p.z() <= 0.7; });
  const SurfaceObstacle obstacle(modelOf(surface), {everywhere()});
  EXPECT_TRUE(obstructedTriangles(patchOf(cap), obstacle).empty());
}

} // namespace
} // namespace pcl::repair
