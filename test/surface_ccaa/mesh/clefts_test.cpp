// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a surface faces itself across hardly any space.
#include <gtest/gtest.h>

#include "mesh/clefts.h"
#include "mesh/sharp_edges.h"
#include "support/completion_shapes.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa::test {
namespace {

/** Two funnels, mouth to the outside, joined at their tips by a ring of such a radius:
 * between them is a groove that is twice as wide as each is high. Their outer radius is
 * 1, that of the ring at z = 0 another one. */
Shape
funnels(double height, double ring)
{
  Shape shape = cylinder(48, 80, 1.0, 2.0);
  double lowest = 1e300;
  for (const Position& vertex : shape.vertices)
    lowest = std::min(lowest, vertex.z());
  for (Position& vertex : shape.vertices) {
    const double t = vertex.z() - lowest - 1.0;
    const double radius = ring + (1.0 - ring) * std::abs(t);
    vertex = {radius * vertex.x(), radius * vertex.y(), height * t};
  }
  return shape;
}

std::vector<std::uint8_t>
cleftsOf(const Shape& shape, int threads = 1)
{
  const TriangleAdjacency adjacency = adjacencyOf(shape);
  const PointView points(shape.vertices);
  const LoopContext context{threads, nullptr, "", 64};
  const SharpEdges edges = findSharpEdges(shape.triangles, adjacency, points, context);
  return cleftVertices(edges.concave, shape.triangles, adjacency, points, context);
}

std::vector<pcl::index_t>
neckVerticesOf(const Shape& shape, const std::vector<ThinNeck>& thin)
{
  return neckVertices(thin,
                      cleftsOf(shape),
                      shape.triangles,
                      adjacencyOf(shape),
                      PointView(shape.vertices));
}

std::size_t
countNecks(const Shape& shape)
{
  return neckVerticesOf(shape, {}).size();
}

TEST(SharpEdges, OfACubeAreItsEdgesAndConcaveFromInside)
{
  constexpr int DIVISIONS = 4;
  Shape shape = cube(DIVISIONS);
  const auto edgesOf = [](const Shape& of) {
    return findSharpEdges(of.triangles, adjacencyOf(of), PointView(of.vertices), {});
  };
  EXPECT_EQ(12U * DIVISIONS, edgesOf(shape).convex.size());
  EXPECT_EQ(0U, edgesOf(shape).concave.size());
  shape.triangles = reversed(shape.triangles);
  EXPECT_EQ(0U, edgesOf(shape).convex.size());
  EXPECT_EQ(12U * DIVISIONS, edgesOf(shape).concave.size());
}

TEST(Clefts, AreAtTheBottomOfASharpGrooveAlone)
{
  const Shape shape = funnels(0.2, 0.1);
  const auto is_cleft = cleftsOf(shape);
  for (std::size_t v = 0; v < is_cleft.size(); ++v) {
    const double depth = std::abs(shape.vertices[v].z()) / 0.2;
    if (depth < 0.01) {
      EXPECT_EQ(1, is_cleft[v]);
    }
    else if (depth > 0.2) {
      EXPECT_EQ(0, is_cleft[v]) << depth;
    }
  }
}

TEST(Clefts, ARightAngleIsNone)
{
  const auto is_cleft = cleftsOf(funnels(0.8, 0.2));
  EXPECT_EQ(0, std::count(is_cleft.begin(), is_cleft.end(), 1));
}

TEST(Clefts, ARidgeIsNone)
{
  Shape shape = funnels(0.2, 0.1);
  shape.triangles = reversed(shape.triangles);
  const auto is_cleft = cleftsOf(shape);
  EXPECT_EQ(0, std::count(is_cleft.begin(), is_cleft.end(), 1));
}

TEST(Clefts, AreTheSameForAnyNumberOfThreads)
{
  const Shape shape = funnels(0.1, 0.3);
  EXPECT_EQ(cleftsOf(shape, 1), cleftsOf(shape, 4));
}

TEST(NeckVertices, ACleftAroundANarrowRingIsOne)
{
  EXPECT_EQ(1U, countNecks(funnels(0.2, 0.1)));
}

TEST(NeckVertices, ACleftAroundAWideRingIsNone)
{
  EXPECT_EQ(0U, countNecks(funnels(0.2, 0.7)));
}

TEST(NeckVertices, AWideGrooveIsNone) { EXPECT_EQ(0U, countNecks(funnels(0.8, 0.2))); }

TEST(NeckVertices, AnOpeningInTheCleftIsAPartOfIt)
{
  const Shape shape = funnels(0.2, 0.1);
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    if (std::all_of(
            shape.triangles[t].begin(), shape.triangles[t].end(), [&](auto corner) {
              const Position& place = shape.vertices[static_cast<std::size_t>(corner)];
              return place.y() > 0.09 && std::abs(place.z()) < 0.011;
            }))
      removed.push_back(t);
  ASSERT_FALSE(removed.empty());
  EXPECT_EQ(1U, countNecks(withoutTriangles(shape, removed)));
}

TEST(NeckVertices, ThinNecksAreAmongThemButNotTheirHandles)
{
  EXPECT_EQ(std::vector<pcl::index_t>{7},
            neckVerticesOf(icosphere(3), {{7, {7}}, {3, {3}, true}}));
}

TEST(NeckVertices, ANeckIsToldOnce)
{
  const Shape shape = funnels(0.2, 0.1);
  std::vector<pcl::index_t> all(shape.vertices.size());
  for (std::size_t v = 0; v < all.size(); ++v)
    all[v] = static_cast<pcl::index_t>(v);
  EXPECT_EQ(std::vector<pcl::index_t>{9}, neckVerticesOf(shape, {{9, all}}));
}

} // namespace
} // namespace pcl::ccaa::test
