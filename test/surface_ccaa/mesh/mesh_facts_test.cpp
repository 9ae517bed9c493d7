// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/mesh_facts.h.
#include <gtest/gtest.h>

#include "mesh/mesh_facts.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <limits>
#include <numeric>

namespace pcl::ccaa::test {
namespace {

MeshFacts
measure(const Shape& shape)
{
  RunControl control;
  return measureMesh(shape.triangles, shape.vertices, {}, control);
}

TEST(MeshFacts, OfAnEmptyMeshAreZero)
{
  const MeshFacts facts = measure({});
  EXPECT_EQ(facts.components, 0u);
  EXPECT_FALSE(facts.genus.has_value());
  EXPECT_EQ(facts.smallest_angle, 0.0);
  EXPECT_EQ(facts.shareOfVertices(0), 0.0);
}

TEST(MeshFacts, CountsPointsByTheirRole)
{
  Shape shape = grid(4, 3);
  shape.vertices.push_back({9.0, 9.0, 9.0});
  const MeshFacts facts = measure(shape);
  EXPECT_EQ(facts.vertices, 13u);
  EXPECT_EQ(facts.used_vertices, 12u);
  EXPECT_EQ(facts.internal_vertices, 2u);
  EXPECT_EQ(facts.boundary_vertices, 10u);
  EXPECT_EQ(facts.free_vertices, 1u);
}

TEST(MeshFacts, GenusCountsHandlesAndNoOpenings)
{
  EXPECT_EQ(measure(icosphere(2)).genus, 0);
  EXPECT_EQ(measure(torus(12, 8)).genus, 1);
  EXPECT_EQ(measure(joined(torus(12, 8), icosphere(1, 9.0))).genus, 1);
  EXPECT_EQ(measure(cylinder(8, 3)).genus, 0);
  EXPECT_EQ(measure(joined(torus(12, 8), grid(4, 4))).genus, 1);
  EXPECT_FALSE(measure(moebiusBand(8)).genus.has_value());
}

TEST(MeshFacts, EulerCharacteristic)
{
  EXPECT_EQ(measure(tetrahedron()).euler_characteristic, 2);
  EXPECT_EQ(measure(torus(9, 7)).euler_characteristic, 0);
  EXPECT_EQ(measure(cylinder(9, 7)).euler_characteristic, 0);
  EXPECT_EQ(measure(grid(5, 5)).euler_characteristic, 1);
}

TEST(MeshFacts, BoundaryLoopsAreSortedByTheirEdges)
{
  const MeshFacts facts =
      measure(joined(grid(3, 3), translated(cylinder(12, 2), {9.0, 0.0, 0.0})));
  ASSERT_EQ(facts.boundary_loops.size(), 3u);
  EXPECT_EQ(facts.boundary_loops[0].edges, 12u);
  EXPECT_EQ(facts.boundary_loops[1].edges, 12u);
  EXPECT_EQ(facts.boundary_loops[2].edges, 8u);
  EXPECT_DOUBLE_EQ(facts.boundary_loops[2].length, 8.0);
  EXPECT_EQ(facts.boundary_edges, 32u);
}

TEST(MeshFacts, HolesThatTouchAtAVertexAreTwoLoops)
{
  const Shape sheet = grid(6, 6);
  // The squares (1,1) and (2,2) have only vertex (2,2) in common.
  const auto square = [](std::size_t x, std::size_t y) { return 2 * (5 * y + x); };
  const Shape shape = withoutTriangles(
      sheet, {square(1, 1), square(1, 1) + 1, square(2, 2), square(2, 2) + 1});
  const MeshFacts facts = measure(shape);
  ASSERT_EQ(facts.boundary_loops.size(), 2u);
  EXPECT_EQ(facts.boundary_loops[0].edges, 20u);
  EXPECT_EQ(facts.boundary_loops[1].edges, 8u);
  EXPECT_EQ(facts.non_manifold_vertices, 1u);
}

TEST(MeshFacts, ABowTieIsTwoComponentsWithALoopEach)
{
  const MeshFacts facts = measure(bowTie());
  EXPECT_EQ(facts.components, 2u);
  EXPECT_EQ(facts.boundary_loops.size(), 2u);
  EXPECT_EQ(facts.non_manifold_vertices, 1u);
  EXPECT_EQ(facts.non_manifold_edges, 0u);
}

TEST(MeshFacts, TwoFansAtAnApexAreANonManifoldVertex)
{
  const MeshFacts facts = measure(twoFansAtApex());
  EXPECT_EQ(facts.non_manifold_vertices, 1u);
  EXPECT_EQ(facts.internal_vertices, 0u);
}

TEST(MeshFacts, ThreeTrianglesOnAnEdgeAreOneComponent)
{
  const MeshFacts facts = measure(threeOnEdge());
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.non_manifold_edges, 1u);
  EXPECT_EQ(facts.non_manifold_vertices, 0u);
  EXPECT_EQ(facts.boundary_edges, 6u);
}

TEST(MeshFacts, MisorientedEdgesSurroundAReversedTriangle)
{
  Shape shape = icosphere(2);
  std::swap(shape.triangles[9][1], shape.triangles[9][2]);
  const MeshFacts facts = measure(shape);
  EXPECT_EQ(facts.misoriented_edges, 3u);
  EXPECT_TRUE(facts.orientable);
  EXPECT_FALSE(facts.volume.has_value());
}

TEST(MeshFacts, AMoebiusBandIsNotOrientable)
{
  const MeshFacts facts = measure(moebiusBand(9));
  EXPECT_FALSE(facts.orientable);
  EXPECT_EQ(facts.boundary_loops.size(), 1u);
  EXPECT_EQ(facts.boundary_loops[0].edges, 18u);
}

TEST(MeshFacts, AreaAndVolumeOfACube)
{
  Shape shape = translated(cube(3, 2.0), {100.0, 200.0, 300.0});
  MeshFacts facts = measure(shape);
  EXPECT_NEAR(facts.area, 24.0, 1e-9);
  ASSERT_TRUE(facts.volume.has_value());
  EXPECT_NEAR(*facts.volume, 8.0, 1e-9);
  shape.triangles = reversed(shape.triangles);
  EXPECT_NEAR(*measure(shape).volume, -8.0, 1e-9);
}

TEST(MeshFacts, InvalidTrianglesAreLeftOut)
{
  Shape shape = tetrahedron();
  shape.triangles.push_back({0, 1, 4});
  shape.triangles.push_back({-1, 1, 2});
  shape.triangles.push_back({1, 1, 2});
  const MeshFacts facts = measure(shape);
  EXPECT_EQ(facts.invalid_triangles, 3u);
  EXPECT_EQ(facts.triangles, 4u);
  EXPECT_EQ(facts.genus, 0);
}

TEST(MeshFacts, DegenerateTrianglesAreFoundExactly)
{
  const Shape shape{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 1e-12, 0}},
                    {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_EQ(measure(shape).degenerate_triangles, 1u);
}

TEST(MeshFacts, NonFiniteTrianglesAreCountedApart)
{
  Shape shape = icosphere(1);
  shape.vertices[0].x() = std::numeric_limits<double>::infinity();
  const MeshFacts facts = measure(shape);
  EXPECT_EQ(facts.non_finite_triangles, 5u);
  EXPECT_TRUE(std::isfinite(facts.area));
  EXPECT_FALSE(facts.volume.has_value());
  EXPECT_EQ(
      std::accumulate(facts.minimum_angles.begin(), facts.minimum_angles.end(), 0u),
      75u);
}

TEST(MeshFacts, AnglesOfRightTriangles)
{
  const MeshFacts facts = measure(grid(5, 5));
  EXPECT_NEAR(facts.smallest_angle, 45.0, 1e-9);
  EXPECT_EQ(facts.angles[9], 32u);
  EXPECT_EQ(facts.angles[4], 64u);
  EXPECT_EQ(std::accumulate(facts.angles.begin(), facts.angles.end(), 0u), 96u);
}

TEST(MeshFacts, EquilateralTrianglesFallIntoTheLastBin)
{
  const MeshFacts facts = measure(icosphere(0));
  EXPECT_NEAR(facts.smallest_angle, 60.0, 1e-9);
  EXPECT_EQ(facts.minimum_angles.back(), 20u);
}

TEST(MeshFacts, SelfIntersectionsOnlyWhenAskedFor)
{
  const Shape shape = joined(icosphere(2), translated(icosphere(2), {1.0, 0.1, 0.2}));
  EXPECT_GT(measure(shape).self_intersections.value_or(0), 0u);
  MeshFactsOptions options;
  options.self_intersections = false;
  RunControl control;
  const MeshFacts facts =
      measureMesh(shape.triangles, shape.vertices, options, control);
  EXPECT_FALSE(facts.self_intersections.has_value());
}

TEST(MeshFacts, DoNotDependOnTheOrderOfVerticesAndTriangles)
{
  const Shape shape = withoutTriangles(torus(20, 10), {3, 4, 5, 70, 200});
  const MeshFacts facts = measure(shape), other = measure(shuffled(shape, 3));
  EXPECT_EQ(facts.euler_characteristic, other.euler_characteristic);
  EXPECT_EQ(facts.internal_vertices, other.internal_vertices);
  ASSERT_EQ(facts.boundary_loops.size(), other.boundary_loops.size());
  for (std::size_t i = 0; i < facts.boundary_loops.size(); ++i)
    EXPECT_EQ(facts.boundary_loops[i].edges, other.boundary_loops[i].edges);
}

TEST(MeshFacts, CancellingIsReported)
{
  const Shape shape = icosphere(2);
  RunControl control([](const std::string&, double) { return false; });
  EXPECT_TRUE(measureMesh(shape.triangles, shape.vertices, {}, control).cancelled);
}

} // namespace
} // namespace pcl::ccaa::test
