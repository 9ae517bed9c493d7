// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/intersection.h.
#include <gtest/gtest.h>

#include "mesh/intersection.h"
#include "support/random_source.h"
#include "support/shapes.h"

#include <limits>

namespace pcl::ccaa::test {
namespace {

const Corners FLOOR = {Position(0, 0, 0), Position(4, 0, 0), Position(0, 4, 0)};

/** Whole numbers from 0 to 3: many of them are coplanar, or alike. */
Corners
anyTriangle(RandomSource& random)
{
  Corners corners;
  for (Position& corner : corners)
    for (Eigen::Index k = 0; k < 3; ++k)
      corner[k] = static_cast<double>(random.below(4));
  return corners;
}

SelfIntersections
find(const Shape& shape, int threads = 1)
{
  RunControl control;
  return findSelfIntersections(shape.triangles, shape.vertices, threads, control);
}

TEST(SegmentMeetsTriangle, ThroughTheInside)
{
  EXPECT_TRUE(segmentMeetsTriangle({1, 1, -1}, {1, 1, 1}, FLOOR));
  EXPECT_FALSE(segmentMeetsTriangle({3, 3, -1}, {3, 3, 1}, FLOOR));
}

TEST(SegmentMeetsTriangle, NotWhenItEndsBefore)
{
  EXPECT_FALSE(segmentMeetsTriangle({1, 1, 2}, {1, 1, 1e-300}, FLOOR));
  EXPECT_TRUE(segmentMeetsTriangle({1, 1, 2}, {1, 1, 0}, FLOOR));
}

TEST(SegmentMeetsTriangle, TouchingACornerOrAnEdgeCounts)
{
  EXPECT_TRUE(segmentMeetsTriangle({0, 0, -1}, {0, 0, 1}, FLOOR));
  EXPECT_TRUE(segmentMeetsTriangle({2, 2, -1}, {2, 2, 1}, FLOOR));
  EXPECT_FALSE(segmentMeetsTriangle({2, 2.0000001, -1}, {2, 2.0000001, 1}, FLOOR));
}

TEST(SegmentMeetsTriangle, InItsPlane)
{
  EXPECT_TRUE(segmentMeetsTriangle({-1, 1, 0}, {9, 1, 0}, FLOOR));
  EXPECT_TRUE(segmentMeetsTriangle({1, 1, 0}, {1.5, 1, 0}, FLOOR));
  EXPECT_TRUE(segmentMeetsTriangle({-1, 0, 0}, {0, 0, 0}, FLOOR));
  EXPECT_FALSE(segmentMeetsTriangle({-2, 0, 0}, {-1, 0, 0}, FLOOR));
  EXPECT_FALSE(segmentMeetsTriangle({5, 0, 0}, {0, 5, 0}, FLOOR));
}

TEST(SegmentMeetsTriangle, InItsPlaneOverEachOfItsEdges)
{
  for (const Position& outside :
       {Position(-1, 1, 0), Position(1, -1, 0), Position(4, 4, 0)}) {
    EXPECT_TRUE(segmentMeetsTriangle(outside, {1, 1, 0}, FLOOR));
    EXPECT_TRUE(segmentMeetsTriangle({1, 1, 0}, outside, FLOOR));
  }
}

TEST(TrianglesMeet, WithoutACommonCornerWhenTheyCross)
{
  EXPECT_TRUE(trianglesMeet(FLOOR, {Position(1, 1, -1), {1, 1, 1}, {5, 5, 0}}));
  EXPECT_FALSE(trianglesMeet(FLOOR, {Position(1, 1, 1), {1, 1, 2}, {5, 5, 1}}));
}

TEST(TrianglesMeet, WhenOneLiesInsideTheOther)
{
  const Corners inside = {Position(1, 1, 0), Position(1.5, 1, 0), Position(1, 1.5, 0)};
  EXPECT_TRUE(trianglesMeet(FLOOR, inside));
  EXPECT_TRUE(trianglesMeet(inside, FLOOR));
}

TEST(TrianglesMeet, WithoutACommonCornerTouchingCounts)
{
  EXPECT_TRUE(trianglesMeet(FLOOR, {Position(1, 1, 0), {1, 2, 3}, {2, 1, 3}}));
  EXPECT_FALSE(trianglesMeet(FLOOR, {Position(1, 1, 1e-12), {1, 2, 3}, {2, 1, 3}}));
}

TEST(TrianglesMeet, AtACommonCornerOnlyWhenAFarEdgeMeetsTheOther)
{
  EXPECT_FALSE(trianglesMeet(FLOOR, {Position(0, 0, 0), {-1, 0, 1}, {0, -1, 1}}));
  EXPECT_TRUE(trianglesMeet(FLOOR, {Position(0, 0, 0), {1, 1, 1}, {1, 1, -1}}));
  EXPECT_TRUE(trianglesMeet(FLOOR, {Position(0, 0, 0), {1, 2, 0}, {2, 1, 0}}));
}

TEST(TrianglesMeet, AtACommonCornerAsTheFarEdgesTell)
{
  RandomSource random(6);
  for (int i = 0; i < 3000; ++i) {
    const Corners s = anyTriangle(random);
    Corners t = anyTriangle(random);
    t[0] = s[0];
    const bool another_common =
        s[1] == t[1] || s[1] == t[2] || s[2] == t[1] || s[2] == t[2];
    if (isCollinear(s) || isCollinear(t) || another_common)
      continue;
    EXPECT_EQ(trianglesMeet(s, t),
              segmentMeetsTriangle(s[1], s[2], t) ||
                  segmentMeetsTriangle(t[1], t[2], s));
  }
}

TEST(TrianglesMeet, AtACommonEdgeOnlyWhenTheyFoldOntoEachOther)
{
  const Position p = FLOOR[0], q = FLOOR[1];
  EXPECT_TRUE(trianglesMeet(FLOOR, {q, p, Position(1, 1, 0)}));
  EXPECT_FALSE(trianglesMeet(FLOOR, {q, p, Position(1, -1, 0)}));
  EXPECT_FALSE(trianglesMeet(FLOOR, {q, p, Position(1, 1, 1e-9)}));
}

TEST(TrianglesMeet, WithTheSameThreeCornersAlways)
{
  EXPECT_TRUE(trianglesMeet(FLOOR, {FLOOR[2], FLOOR[1], FLOOR[0]}));
}

TEST(TrianglesMeet, DoesNotDependOnTheOrderOfTrianglesOrCorners)
{
  RandomSource random(5);
  for (int i = 0; i < 3000; ++i) {
    const Corners s = anyTriangle(random), t = anyTriangle(random);
    if (isCollinear(s) || isCollinear(t))
      continue;
    const bool meet = trianglesMeet(s, t);
    EXPECT_EQ(meet, trianglesMeet(t, s));
    EXPECT_EQ(meet, trianglesMeet({s[1], s[2], s[0]}, {t[2], t[1], t[0]}));
  }
}

TEST(SelfIntersections, CorrectShapesHaveNone)
{
  for (const Shape& shape : {icosphere(3),
                             torus(30, 15),
                             cube(5),
                             terrain(20, 20),
                             nestedSpheres(2),
                             moebiusBand(20),
                             bowTie()})
    EXPECT_TRUE(find(shape).pairs.empty());
}

TEST(SelfIntersections, TwoSpheresCross)
{
  const Shape shape = joined(icosphere(2), translated(icosphere(2), {1.0, 0.1, 0.2}));
  const SelfIntersections found = find(shape);
  EXPECT_FALSE(found.pairs.empty());
  EXPECT_TRUE(std::is_sorted(found.pairs.begin(), found.pairs.end()));
  for (const TrianglePair& pair : found.pairs) {
    EXPECT_LT(pair.first, 320);
    EXPECT_GE(pair.second, 320);
  }
}

TEST(SelfIntersections, VerticesInOnePlaceAreOneVertex)
{
  // Both halves of a square with corners of their own: they only share an edge.
  const Shape shape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                    {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_TRUE(find(shape).pairs.empty());
}

TEST(SelfIntersections, DuplicatedTrianglesMeet)
{
  Shape shape = icosphere(1);
  shape.triangles.push_back(shape.triangles[17]);
  const SelfIntersections found = find(shape);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0], TrianglePair(17, 80));
}

TEST(SelfIntersections, LeavesOutWhatIsNoTriangle)
{
  Shape shape = icosphere(1);
  const auto count = static_cast<index_t>(shape.vertices.size());
  shape.vertices.push_back({0.0, 0.0, std::numeric_limits<double>::quiet_NaN()});
  shape.vertices.push_back(2.0 * shape.vertices[1] - shape.vertices[0]);
  shape.triangles.push_back({0, 1, count});
  shape.triangles.push_back({0, 1, count + 2});
  shape.triangles.push_back({0, 1, -1});
  shape.triangles.push_back({0, 1, 1});
  EXPECT_EQ(find(shape).left_out, 4u);
  EXPECT_TRUE(find(shape).pairs.empty());
}

TEST(SelfIntersections, FindsWhatTestingEveryPairFinds)
{
  RandomSource random(6);
  Shape shape;
  for (int i = 0; i < 600; ++i)
    shape.vertices.emplace_back(random.uniform(), random.uniform(), random.uniform());
  for (int i = 0; i < 300; ++i) {
    const auto first = static_cast<index_t>(random.below(590));
    shape.triangles.push_back({first, first + 3, first + 7});
  }
  std::vector<TrianglePair> expected;
  const auto corners = [&](std::size_t i) {
    const PointView view(shape.vertices);
    const Triangle& t = shape.triangles[i];
    return Corners{view[t[0]], view[t[1]], view[t[2]]};
  };
  for (std::size_t i = 0; i < 300; ++i)
    for (std::size_t j = i + 1; j < 300; ++j)
      if (trianglesMeet(corners(i), corners(j)))
        expected.emplace_back(static_cast<index_t>(i), static_cast<index_t>(j));
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(find(shape).pairs, expected);
}

TEST(SelfIntersections, AreTheSameForAnyNumberOfThreads)
{
  const Shape shape = joined(icosphere(4), translated(icosphere(4), {0.5, 0.1, 0.2}));
  const std::vector<TrianglePair> expected = find(shape).pairs;
  for (const int threads : {2, 4})
    EXPECT_EQ(find(shape, threads).pairs, expected);
}

TEST(SelfIntersections, CancellingLeavesNoPairs)
{
  const Shape shape = joined(icosphere(4), translated(icosphere(4), {0.5, 0.1, 0.2}));
  RunControl control(
      [](const std::string&, double fraction) { return fraction < 0.5; });
  const SelfIntersections found =
      findSelfIntersections(shape.triangles, shape.vertices, 1, control);
  EXPECT_TRUE(found.cancelled);
  EXPECT_TRUE(found.pairs.empty());
}

} // namespace
} // namespace pcl::ccaa::test
