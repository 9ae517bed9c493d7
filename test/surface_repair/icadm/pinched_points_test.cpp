// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of closing holes that meet in a point.

#include <gtest/gtest.h>

#include "icadm/pinched_points.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <set>

namespace pcl::repair::test {
namespace {

VertexMap
pinchedOf(const IncompleteModel& model)
{
  return pinchedVertices(model, extractBoundaries(model));
}

std::set<pcl::index_t>
verticesOf(const Triangles& triangles)
{
  std::set<pcl::index_t> vertices;
  for (const Triangle& triangle : triangles)
    vertices.insert(triangle.begin(), triangle.end());
  return vertices;
}

std::size_t
countOpen(const Repaired& result)
{
  const auto& holes = result.report.holes;
  return static_cast<std::size_t>(
      std::count_if(holes.begin(), holes.end(), [](const RepairedHole& hole) {
        return hole.open != OpenReason::NONE;
      }));
}

/** A square, its border, and two holes within that meet in a point: of two triangles
 * and of many. */
Shape
smallAndLargeHole()
{
  return without(grid(16, 16), [](const Position& p) {
    const bool is_small = p.x() > 3 && p.x() < 4 && p.y() > 3 && p.y() < 4;
    const bool is_large = p.x() > 4 && p.x() < 11 && p.y() > 4 && p.y() < 11;
    return is_small || is_large;
  });
}

TEST(PinchedPoints, WeldedFansShareAVertex)
{
  IncompleteModel model = readingOf(pinchedSphere(3));
  const VertexMap pinched = pinchedOf(model);
  weldPinches(pinched, {}, model);
  for (const auto& [vertex, kept] : pinched) {
    EXPECT_EQ(model.adjacency.begin(vertex), model.adjacency.end(vertex));
    EXPECT_EQ(ccaa::Fan::SEVERAL, model.adjacency.fan(kept));
  }
}

TEST(PinchedPoints, SeparatingTakesWeldingBack)
{
  for (const std::size_t holes : {2U, 3U}) {
    IncompleteModel model = readingOf(pinchedSphere(holes));
    const std::size_t vertices = model.positions.size();
    weldPinches(pinchedOf(model), {}, model);
    separatePinches({}, model);
    EXPECT_EQ(vertices, model.positions.size());
    EXPECT_EQ(vertices, model.point_of_vertex.size());
    EXPECT_TRUE(isIcadm(model.triangles, vertices));
  }
}

TEST(PinchedPoints, NumbersAfterSeparatingLeadToTheSamePoints)
{
  IncompleteModel model = readingOf(pinchedSphere(3));
  const std::vector<pcl::index_t> points = model.point_of_vertex;
  const VertexMap pinched = pinchedOf(model);
  weldPinches(pinched, {}, model);
  const std::vector<pcl::index_t> number = separatePinches({}, model);
  ASSERT_EQ(points.size(), number.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    const bool is_replaced = pinched.count(static_cast<pcl::index_t>(v)) > 0;
    ASSERT_EQ(is_replaced, number[v] == pcl::UNAVAILABLE);
    if (!is_replaced) {
      EXPECT_EQ(points[v], model.point_of_vertex[static_cast<std::size_t>(number[v])]);
    }
  }
}

TEST(HolesThatMeet, AreClosedWithNoCopyOfThePoint)
{
  for (const std::size_t holes : {2U, 3U}) {
    const Repaired result = repaired(pinchedSphere(holes));
    EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
    EXPECT_TRUE(isSubsetOf(toTriangles(result.input.polygons), result.triangles()));
    expectNothingWorse(result, toTriangles(result.input.polygons));
    EXPECT_EQ(verticesOf(result.triangles()).size(),
              verticesOf(toTriangles(result.input.polygons)).size() +
                  result.report.new_vertices);
  }
}

TEST(HolesThatMeet, AreClosedInARowOfFacesThatAreMissing)
{
  Shape sphere = icosphere(6);
  sphere.triangles.erase(sphere.triangles.begin(), sphere.triangles.begin() + 8);
  const Repaired result = repaired(sphere);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  expectNothingWorse(result, toTriangles(result.input.polygons));
}

TEST(HolesThatMeet, ShareThePointWhenOneOfTwoStaysOpen)
{
  RepairParameters parameters;
  parameters.filling.greatest_hole = 10;
  const Repaired result = repaired(smallAndLargeHole(), parameters);
  EXPECT_EQ(2U, countOpen(result)); // and the border
  EXPECT_EQ(60U + 28U, countBoundaryEdges(result.triangles()));
  expectNothingWorse(result, toTriangles(result.input.polygons));
  EXPECT_EQ(pointsOf(result.input), pointsOf(result.output));
}

TEST(HolesThatMeet, KeepTheirFansApartWhenNoneIsClosed)
{
  RepairParameters parameters;
  parameters.filling.greatest_hole = 2;
  const Repaired result = repaired(pinchedSphere(3), parameters);
  EXPECT_EQ(9U, countBoundaryEdges(result.triangles()));
  EXPECT_EQ(2U, result.report.new_vertices);
  EXPECT_TRUE(isIcadm(result.triangles(), pointsOf(result.output)));
}

TEST(HolesThatMeet, AreClosedAtTheOuterBorder)
{
  const Repaired result = repaired(pinchedBorder());
  EXPECT_EQ(28U, countBoundaryEdges(result.triangles()));
  EXPECT_EQ(1U, countOpen(result));
  expectNothingWorse(result, toTriangles(result.input.polygons));
}

/** Triangles of a closed shape, one after the other, but none beside another one. */
std::vector<std::size_t>
scatteredTriangles(const Shape& shape, std::size_t step)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  std::set<pcl::index_t> beside;
  std::vector<std::size_t> scattered;
  for (std::size_t t = 0; t < shape.triangles.size(); t += step) {
    const auto triangle = static_cast<pcl::index_t>(t);
    if (beside.count(triangle) > 0)
      continue;
    scattered.push_back(t);
    for (int corner = 0; corner < 3; ++corner)
      beside.insert(adjacency.across(triangle, corner));
  }
  return scattered;
}

TEST(HolesThatMeet, AreClosedAtManyPoints)
{
  const Shape sphere = shuffled(icosphere(3), 3);
  const std::vector<std::size_t> removed = scatteredTriangles(sphere, 9);
  const Repaired result = repaired(withoutTriangles(sphere, removed));
  EXPECT_GT(result.report.reading.separated_fans, 20U);
  EXPECT_EQ(removed.size(), result.report.holes.size());
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  expectNothingWorse(result, toTriangles(result.input.polygons));
}

/** Two triangles that meet in a point have a vertex there each; new triangles beside
 * both run along the same edge, to the vertex after them. */
TEST(PinchedPoints, ASlitBetweenTwoNewTrianglesIsFound)
{
  const IncompleteModel model = readingOf(bowTie());
  ASSERT_EQ(6U, model.positions.size());
  const auto is_copy = [&](pcl::index_t vertex) {
    return std::count(model.point_of_vertex.begin(),
                      model.point_of_vertex.end(),
                      model.point_of_vertex[static_cast<std::size_t>(vertex)]) == 2;
  };
  const auto from_copy = [&](Triangle triangle) {
    while (!is_copy(triangle[0]))
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    return triangle;
  };
  const Triangle one = from_copy(model.triangles[0]);
  const Triangle two = from_copy(model.triangles[1]);
  const pcl::index_t next = 6;
  const Triangle before = {one[1], one[0], next};
  const Triangle after = {next, two[0], two[2]};
  const Triangle between = {one[1], next, two[2]};
  const VertexMap expected = {{std::max(one[0], two[0]), std::min(one[0], two[0])}};
  EXPECT_EQ(expected, slitsBetween(model, {before, after, between}));
  EXPECT_TRUE(slitsBetween(model, {before, between}).empty());
}

} // namespace
} // namespace pcl::repair::test
