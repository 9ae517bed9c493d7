// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of walking boundaries.
#include <gtest/gtest.h>

#include "boundary/extraction.h"
#include "boundary_models.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <set>

namespace pcl::repair::test {
namespace {

using namespace ccaa::test;

Position
conormal(const BoundaryCurve& curve, std::size_t k)
{
  return curve.edge(k).normalized().cross(curve.normals[k]);
}

TEST(Extraction, AClosedSurfaceHasNoLoop)
{
  EXPECT_TRUE(extractBoundaries(modelOf(torus(12, 8))).empty());
}

TEST(Extraction, AGridHasOneLoopCounterClockwise)
{
  const BoundaryLoops loops = extractBoundaries(modelOf(grid(6, 5)));
  ASSERT_EQ(1u, loops.size());
  EXPECT_EQ(18u, loops[0].curve.size());
  EXPECT_DOUBLE_EQ(18.0, loops[0].length);
  Position twice_area = Position::Zero();
  for (std::size_t k = 0; k < 18; ++k)
    twice_area +=
        loops[0].curve.points[k].cross(loops[0].curve.points[loops[0].curve.next(k)]);
  EXPECT_NEAR(40.0, twice_area.z(), 1e-12);
}

TEST(Extraction, ATubeHasOneLoopForEachEnd)
{
  const BoundaryLoops loops = extractBoundaries(modelOf(cylinder(30, 5)));
  ASSERT_EQ(2u, loops.size());
  EXPECT_EQ(30u, loops[0].vertices.size());
  EXPECT_EQ(30u, loops[1].vertices.size());
}

TEST(Extraction, ConormalsPointAwayFromTheSurface)
{
  const BoundaryLoops loops = extractBoundaries(modelOf(cylinder(30, 5)));
  for (const BoundaryLoop& loop : loops)
    for (std::size_t k = 0; k < loop.curve.size(); ++k) {
      const double outward = loop.curve.points[k].z() > 1.0 ? 1.0 : -1.0;
      EXPECT_NEAR(outward, conormal(loop.curve, k).z(), 0.01);
    }
}

TEST(Extraction, NormalsAreUnitAndPerpendicularToTheirEdge)
{
  const auto model =
      modelOf(without(icosphere(3), [](const Position& p) { return p.z() > 0.6; }));
  for (const BoundaryLoop& loop : extractBoundaries(model))
    for (std::size_t k = 0; k < loop.curve.size(); ++k) {
      EXPECT_NEAR(1.0, loop.curve.normals[k].norm(), 1e-12);
      EXPECT_NEAR(0.0, loop.curve.normals[k].dot(loop.curve.edge(k)), 1e-12);
    }
}

TEST(Extraction, EachLoopBeginsAtItsLowestHalfEdge)
{
  const auto model = modelOf(shuffled(cylinder(15, 4), 2));
  const BoundaryLoops loops = extractBoundaries(model);
  for (const BoundaryLoop& loop : loops)
    EXPECT_EQ(loop.triangles[0],
              *std::min_element(loop.triangles.begin(), loop.triangles.end()));
  EXPECT_LT(loops[0].triangles[0], loops[1].triangles[0]);
}

TEST(Extraction, FindsEveryBoundaryEdgeOnce)
{
  Shape shape = shuffled(terrain(30, 30), 4);
  int count = 0;
  shape = without(shape, [&](const Position&) { return ++count % 40 == 0; });
  std::size_t edges = 0;
  for (const BoundaryLoop& loop : extractBoundaries(modelOf(shape)))
    edges += loop.vertices.size();
  EXPECT_EQ(countBoundaryEdges(shape.triangles), edges);
}

TEST(Extraction, LoopsKnowTheirIsland)
{
  const auto model = modelOf(joined(icosphere(1), cylinder(8, 3)));
  for (const BoundaryLoop& loop : extractBoundaries(model))
    EXPECT_EQ(1u, loop.island);
}

TEST(Extraction, AOneSidedIslandIsWalkedAllTheSame)
{
  const BoundaryLoops loops = extractBoundaries(modelOf(moebiusBand(20)));
  ASSERT_EQ(1u, loops.size());
  EXPECT_EQ(40u, loops[0].vertices.size());
}

TEST(Extraction, DegenerateTrianglesStillHaveUnitNormals)
{
  const Shape line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const Shape point{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
  for (const Shape& shape : {line, point}) {
    const BoundaryLoops loops = extractBoundaries(modelOf(shape));
    ASSERT_EQ(1u, loops.size());
    for (const Direction& normal : loops[0].curve.normals)
      EXPECT_NEAR(1.0, normal.norm(), 1e-12);
  }
}

TEST(Extraction, HolesThatMeetInAPointAreLoopsOfTheirOwn)
{
  for (const std::size_t holes : {1U, 2U, 3U}) {
    const BoundaryLoops loops = extractBoundaries(readingOf(pinchedSphere(holes)));
    ASSERT_EQ(holes, loops.size());
    for (const BoundaryLoop& loop : loops)
      EXPECT_EQ(3U, loop.vertices.size());
  }
}

TEST(Extraction, AHoleThatMeetsTheBorderIsALoopOfItsOwn)
{
  const BoundaryLoops loops = extractBoundaries(readingOf(pinchedBorder()));
  ASSERT_EQ(2U, loops.size());
  EXPECT_EQ(28U + 3U, loops[0].vertices.size() + loops[1].vertices.size());
}

TEST(Extraction, IslandsThatTouchHaveALoopEach)
{
  const IncompleteModel model = readingOf(bowTie());
  const BoundaryLoops loops = extractBoundaries(model);
  EXPECT_EQ(2U, loops.size());
  EXPECT_TRUE(pinchedVertices(model, loops).empty());
}

TEST(Extraction, NoLoopPassesAPointTwice)
{
  Shape shape = shuffled(icosphere(3), 5);
  for (const std::size_t step : {3U, 5U, 7U}) {
    std::vector<std::size_t> removed;
    for (std::size_t t = 0; t < shape.triangles.size(); t += step)
      removed.push_back(t);
    const IncompleteModel model = readingOf(withoutTriangles(shape, removed));
    std::size_t edges = 0;
    for (const BoundaryLoop& loop : extractBoundaries(model)) {
      std::set<pcl::index_t> points;
      for (const pcl::index_t vertex : loop.vertices)
        points.insert(model.point_of_vertex[static_cast<std::size_t>(vertex)]);
      EXPECT_EQ(loop.vertices.size(), points.size());
      edges += loop.vertices.size();
    }
    EXPECT_EQ(countBoundaryEdges(model.triangles), edges);
  }
}

TEST(Extraction, PinchedVerticesAreAllOfAPointButTheLowest)
{
  for (const std::size_t holes : {1U, 2U, 3U}) {
    const IncompleteModel model = readingOf(pinchedSphere(holes));
    const auto pinched = pinchedVertices(model, extractBoundaries(model));
    EXPECT_EQ(holes - 1, pinched.size());
    for (const auto& [vertex, kept] : pinched) {
      EXPECT_LT(kept, vertex);
      EXPECT_EQ(model.point_of_vertex[static_cast<std::size_t>(kept)],
                model.point_of_vertex[static_cast<std::size_t>(vertex)]);
    }
  }
}

TEST(BoundaryLoop, LengthOfNothingIsZero) { EXPECT_EQ(0.0, lengthOf({})); }

} // namespace
} // namespace pcl::repair::test
