// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of cutting a mesh where it is no manifold.

#include <gtest/gtest.h>

#include "boundary/extraction.h"
#include "read_shapes.h"
#include "support/random_source.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::pointTriangles;
using test::read;

std::vector<std::size_t>
islandSizes(const IncompleteModel& model)
{
  std::vector<std::size_t> sizes;
  for (const Island& island : model.islands)
    sizes.push_back(island.triangles);
  return sizes;
}

/** A shape with one more triangle, on an edge of it and a point of its own. */
Shape
withFin(Shape shape, const Position& tip)
{
  const Triangle& first = shape.triangles.front();
  shape.triangles.push_back(
      {first[1], first[0], static_cast<pcl::index_t>(shape.vertices.size())});
  shape.vertices.push_back(tip);
  return shape;
}

/** Two sheets that cross in the line x = 3 and have its points in common; so no pair of
 * triangles on it is the only possible one. */
Shape
crossingSheets()
{
  Shape level = grid(7, 4);
  Shape upright = grid(7, 4);
  for (Position& p : upright.vertices)
    p = Position(3.0, p.y(), p.x() - 3.0);
  Shape both = joined(level, upright);
  const auto own = static_cast<pcl::index_t>(level.vertices.size());
  for (Triangle& triangle : both.triangles)
    for (pcl::index_t& corner : triangle)
      if (corner >= own && (corner - own) % 7 == 3)
        corner -= own;
  return both;
}

/** Two cubes with one edge in common, each wound outward. */
Shape
cubesAtAnEdge()
{
  Shape cubes = joined(cube(1), translated(cube(1), Position(1, 1, 0)));
  const std::size_t own = cubes.vertices.size() / 2;
  for (Triangle& triangle : cubes.triangles)
    for (pcl::index_t& corner : triangle)
      for (std::size_t v = 0; v < own; ++v)
        if (cubes.vertices[v] == cubes.vertices[static_cast<std::size_t>(corner)])
          corner = static_cast<pcl::index_t>(v);
  return cubes;
}

/** A ball with a wall through it: a triangle whose edges all have three. */
Shape
neckWithMembrane()
{
  Shape neck = joined(tetrahedron(), tetrahedron());
  neck.vertices.resize(5);
  neck.vertices[4] = Position(1, 1, 1);
  neck.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {3, 1, 4}, {2, 3, 4}};
  neck.triangles.insert(neck.triangles.begin(), {1, 2, 3});
  return neck;
}

/** Any triangles between few points. */
Shape
tangle(std::uint64_t seed)
{
  RandomSource random(seed);
  Shape shape = icosphere(1);
  const auto points = static_cast<std::uint64_t>(6 + seed % 9);
  const auto corner = [&] { return static_cast<pcl::index_t>(random.below(points)); };
  shape.triangles.clear();
  for (int t = 0; t < 40; ++t) {
    const Triangle triangle{corner(), corner(), corner()};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
        triangle[2] != triangle[0])
      shape.triangles.push_back(triangle);
  }
  return shape;
}

TEST(EdgeSheets, AFinIsCutFromAClosedSurfaceThatStaysClosed)
{
  const Shape sphere = icosphere(2);
  const ReadModel found = read(withFin(sphere, Position(2, 2, 2)));
  EXPECT_EQ((std::vector<std::size_t>{sphere.triangles.size(), 1U}),
            islandSizes(found.model));
  EXPECT_TRUE(found.model.islands[0].closed);
  EXPECT_EQ(1U, found.report.overfull_edges);
}

TEST(EdgeSheets, SheetsThatCrossGoOnStraight)
{
  const ReadModel found = read(crossingSheets());
  EXPECT_EQ((std::vector<std::size_t>{36U, 36U}), islandSizes(found.model));
  EXPECT_EQ(3U, found.report.overfull_edges);
  EXPECT_EQ(4U, found.report.separated_fans);
}

TEST(EdgeSheets, BodiesThatTouchAlongAnEdgeBecomeTwo)
{
  const ReadModel found = read(cubesAtAnEdge());
  EXPECT_EQ((std::vector<std::size_t>{12U, 12U}), islandSizes(found.model));
  EXPECT_TRUE(found.model.islands[0].closed && found.model.islands[1].closed);
}

TEST(EdgeSheets, AMembraneIsCutOutOfTheBodyThatItDivides)
{
  const ReadModel found = read(neckWithMembrane());
  EXPECT_EQ((std::vector<std::size_t>{1U, 6U}), islandSizes(found.model));
  EXPECT_TRUE(found.model.islands[1].closed);
}

TEST(EdgeSheets, LoopsAlongCutsAloneBoundNothing)
{
  EXPECT_TRUE(extractBoundaries(read(neckWithMembrane()).model).empty());
  EXPECT_EQ(1U, extractBoundaries(read(withFin(icosphere(2), {2, 2, 2})).model).size());
}

TEST(EdgeSheets, ARepeatedTriangleIsTakenOnceWhicheverWayItIsWound)
{
  for (const bool is_turned : {false, true}) {
    Shape shape = icosphere(2);
    Triangle again = shape.triangles[5];
    if (is_turned)
      std::swap(again[0], again[1]);
    shape.triangles.push_back(again);
    const ReadModel found = read(shape);
    EXPECT_EQ(icosphere(2).triangles, pointTriangles(found.model));
    EXPECT_EQ(1U, found.report.repeated_triangles);
  }
}

TEST(EdgeSheets, ADoubleSidedSurfaceBecomesOne)
{
  Shape shape = grid(5, 5);
  const Triangles back = reversed(shape.triangles);
  shape.triangles.insert(shape.triangles.end(), back.begin(), back.end());
  const ReadModel found = read(shape);
  EXPECT_EQ(grid(5, 5).triangles, pointTriangles(found.model));
  EXPECT_EQ(0U, found.report.reversed_triangles);
}

TEST(EdgeSheets, ATriangleTurnedRoundIsTurnedBackAndNothingElse)
{
  Shape shape = withFin(icosphere(2), Position(2, 2, 2));
  std::swap(shape.triangles[40][0], shape.triangles[40][1]);
  const ReadModel found = read(shape);
  EXPECT_EQ(1U, found.report.reversed_triangles);
  EXPECT_TRUE(sameUnorientedTriangles(shape.triangles, pointTriangles(found.model)));
}

TEST(EdgeSheets, KeepEveryTriangleInOrderAtFewFaults)
{
  for (const Shape& shape :
       {withFin(icosphere(2), Position(2, 2, 2)), crossingSheets(), cubesAtAnEdge()})
    EXPECT_EQ(shape.triangles, pointTriangles(read(shape).model));
}

TEST(EdgeSheets, MakeAManifoldOfAnyTriangles)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Shape shape = tangle(seed);
    const ReadModel found = read(shape);
    ASSERT_EQ("", found.report.problem) << seed;
    ASSERT_TRUE(isIcadm(found.model.triangles, found.model.positions.size())) << seed;
    ASSERT_EQ(shape.triangles.size(),
              found.model.triangles.size() + found.report.repeated_triangles +
                  found.report.twist_triangles)
        << seed;
    ASSERT_TRUE(isSubsetOf(pointTriangles(found.model), shape.triangles)) << seed;
  }
}

TEST(EdgeSheets, DoNotMakeAnIslandOneSided)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Shape shape = crossingSheets();
    shape.triangles = randomlyReversed(shape.triangles, seed);
    const ReadModel found = read(shape);
    EXPECT_TRUE(ccaa::test::isConsistentlyWound(found.model.triangles)) << seed;
    EXPECT_EQ(0U, found.report.twist_triangles) << seed;
  }
}

} // namespace
} // namespace pcl::repair
