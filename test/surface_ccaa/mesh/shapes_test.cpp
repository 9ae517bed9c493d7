// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the test shapes are what they say they are.
#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

namespace pcl::ccaa::test {
namespace {

TEST(Shapes, ClosedOnesAreManifoldAndWoundOutward)
{
  for (const Shape& shape :
       {tetrahedron(), icosphere(2), torus(12, 8), cube(3), nestedSpheres(1)}) {
    EXPECT_TRUE(isIcadm(shape.triangles, shape.vertices.size()));
    EXPECT_TRUE(isConsistentlyWound(shape.triangles));
    EXPECT_EQ(countBoundaryEdges(shape.triangles), 0u);
    EXPECT_GT(signedVolume(shape), 0.0);
  }
}

TEST(Shapes, OpenOnesAreManifold)
{
  for (const Shape& shape :
       {cylinder(9, 3), grid(5, 4), terrain(7, 7), thinPlate(4, 4)}) {
    EXPECT_TRUE(isIcadm(shape.triangles, shape.vertices.size()));
    EXPECT_TRUE(isConsistentlyWound(shape.triangles));
    EXPECT_GT(countBoundaryEdges(shape.triangles), 0u);
  }
}

TEST(Shapes, FaultyOnesAreRefused)
{
  EXPECT_FALSE(isIcadm(bowTie().triangles, 5));
  EXPECT_FALSE(isIcadm(twoFansAtApex().triangles, 9));
  EXPECT_FALSE(isIcadm(threeOnEdge().triangles, 5));
  EXPECT_FALSE(isIcadm({{0, 1, 1}}, 3));
  EXPECT_FALSE(isIcadm({{0, 1, 3}}, 3));
  EXPECT_TRUE(isIcadm(moebiusBand(7).triangles, 14));
  EXPECT_FALSE(isConsistentlyWound(moebiusBand(7).triangles));
}

TEST(Shapes, ComparisonLooksThroughRotationAndOrder)
{
  const Triangles triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_TRUE(sameTriangles(triangles, {{1, 3, 2}, {1, 2, 0}}));
  EXPECT_FALSE(sameTriangles(triangles, {{1, 2, 3}, {1, 2, 0}}));
  EXPECT_TRUE(sameUnorientedTriangles(triangles, {{1, 2, 3}, {1, 2, 0}}));
  EXPECT_FALSE(sameTriangles(triangles, {{0, 1, 2}}));
}

TEST(Shapes, SeededCloudsAreReproducible)
{
  EXPECT_EQ(bumpySphere(200), bumpySphere(200));
  EXPECT_NE(bumpySphere(200, 1), bumpySphere(200, 2));
  EXPECT_EQ(cubeCloud(5).size(), 152u);
  EXPECT_EQ(withDuplicates(fibonacciSphere(10), 5).size(), 50u);
}

TEST(Shapes, GoToPclAndBack)
{
  const Shape shape = torus(8, 6);
  const pcl::PolygonMesh mesh = toPolygonMesh(shape);
  EXPECT_EQ(mesh.cloud.width, 48u);
  EXPECT_EQ(toTriangles(mesh.polygons), shape.triangles);
}

} // namespace
} // namespace pcl::ccaa::test
