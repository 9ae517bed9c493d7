// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what kind of surface a mesh is.
#include <gtest/gtest.h>

#include "mesh/mesh_facts.h"
#include "mesh/surface_topology.h"
#include "support/shapes.h"

namespace pcl::ccaa::test {
namespace {

SurfaceTopology
topologyOfShape(const Shape& shape)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  return topologyOf(shape.triangles, adjacency);
}

TEST(SurfaceTopology, IsThatOfTheMeshFacts)
{
  for (const Shape& shape : {icosphere(2),
                             torus(12, 8),
                             cylinder(8, 3),
                             grid(5, 4),
                             thinPlate(4, 4),
                             nestedSpheres(1),
                             joined(torus(12, 8), grid(4, 4)),
                             threeOnEdge(),
                             withoutTriangles(torus(12, 8), {0, 40, 41, 100})}) {
    RunControl control;
    const MeshFacts facts = measureMesh(shape.triangles, shape.vertices, {}, control);
    const SurfaceTopology topology = topologyOfShape(shape);
    EXPECT_EQ(facts.euler_characteristic, topology.euler_characteristic);
    EXPECT_EQ(facts.genus, topology.genus);
    EXPECT_EQ(facts.isWatertight(), topology.isWatertight());
    if (topology.is_manifold) {
      EXPECT_EQ(facts.components, topology.pieces);
      EXPECT_EQ(facts.boundary_loops.size(), topology.boundary_loops);
    }
  }
}

TEST(SurfaceTopology, WatertightNeedsAllTrianglesWoundAlike)
{
  Shape sphere = icosphere(1);
  EXPECT_TRUE(topologyOfShape(sphere).isWatertight());
  std::swap(sphere.triangles[3][0], sphere.triangles[3][1]);
  EXPECT_FALSE(topologyOfShape(sphere).isWatertight());
}

TEST(SurfaceTopology, NothingIsNotWatertight)
{
  EXPECT_FALSE(topologyOfShape({}).isWatertight());
  EXPECT_FALSE(topologyOfShape({}).genus.has_value());
}

TEST(SurfaceTopology, WhatIsOneSidedOrNoManifoldHasNoGenus)
{
  for (const Shape& shape : {moebiusBand(9), bowTie(), threeOnEdge()})
    EXPECT_FALSE(topologyOfShape(shape).genus.has_value());
}

} // namespace
} // namespace pcl::ccaa::test
