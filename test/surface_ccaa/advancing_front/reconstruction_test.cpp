// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: surfaces that ProjectionCompletion makes from a cloud
// alone.
#include "completion_helpers.h"
#include "support/random_source.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

using Reconstruction = CompletionTest;

/** Triangles with corners on both sides of a height, those near the border of the unit
 * square left out: there a surface may go around. */
std::size_t
countBridges(const Triangles& triangles, const Positions& points, double height)
{
  std::size_t bridges = 0;
  for (const Triangle& t : triangles) {
    int above = 0;
    bool inside = true;
    for (const index_t corner : t) {
      const Position& p = points[std::size_t(corner)];
      inside = inside && p.head<2>().minCoeff() > 0.1 && p.head<2>().maxCoeff() < 0.9;
      above += p.z() > height;
    }
    bridges += inside && above != 0 && above != 3;
  }
  return bridges;
}

TEST_F(Reconstruction, ClosesAnEvenSphere)
{
  const Positions points = fibonacciSphere(2000);
  expectClosed(reconstruct(points), points, 1, 0);
}

TEST_F(Reconstruction, ClosesABumpySphere)
{
  const Positions points = bumpySphere(3000);
  expectClosed(reconstruct(points), points, 1, 0);
}

TEST_F(Reconstruction, ClosesATorus)
{
  const Positions points = torusCloud(3000);
  expectClosed(reconstruct(points), points, 1, 1);
}

TEST_F(Reconstruction, ClosesATorusOfARegularLattice)
{
  const Positions points = torus(48, 20).vertices;
  expectClosed(reconstruct(points), points, 1, 1);
}

TEST_F(Reconstruction, ClosesACubeWithSharpEdges)
{
  const Positions points = cubeCloud(12);
  expectClosed(reconstruct(points), points, 1, 0);
}

TEST_F(Reconstruction, ClosesNestedSpheresApart)
{
  const Positions points = nestedSpheres(4).vertices;
  expectClosed(reconstruct(points), points, 2, 0);
}

TEST_F(Reconstruction, ClosesAThinPlateWithARim)
{
  for (const int layers : {2, 3}) {
    SCOPED_TRACE(layers);
    const Positions points = box(16, 16, layers).vertices;
    expectClosed(reconstruct(points), points, 1, 0);
  }
}

TEST_F(Reconstruction, LeavesAnOpenThinPlateTwoSheets)
{
  const double spacing = 1.0 / 30.0;
  const Positions points = thinPlateCloud(30, 5.0 * spacing);
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.components, 2u);
  EXPECT_EQ(facts.boundary_loops.size(), 2u);
  EXPECT_EQ(facts.free_vertices, 0u);
}

TEST_F(Reconstruction, BuildsNoBridgesBetweenCloseSheets)
{
  const double spacing = 1.0 / 30.0;
  for (const double apart : {2.0, 3.0, 4.0}) {
    SCOPED_TRACE(apart);
    const Positions points = thinPlateCloud(30, apart * spacing);
    const Triangles triangles = reconstruct(points);
    expectSound(triangles, points);
    EXPECT_EQ(countBridges(triangles, points, 0.5 * apart * spacing), 0u);
  }
}

TEST_F(Reconstruction, LeavesTheBorderOfATerrainOpen)
{
  const Positions points = terrainCloud(40);
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.free_vertices, 0u);
  ASSERT_EQ(facts.boundary_loops.size(), 1u);
  EXPECT_EQ(facts.euler_characteristic, 1); // a disc
}

TEST_F(Reconstruction, LeavesTheEndsOfATubeOpen)
{
  const Positions points = cylinderCloud(2000);
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.boundary_loops.size(), 2u);
  EXPECT_EQ(facts.euler_characteristic, 0);
}

TEST_F(Reconstruction, ClosesASlightlyNoisySphere)
{
  const double spacing = std::sqrt(4.0 * M_PI / 3000.0);
  const Positions points = noisySphere(3000, 0.1 * spacing);
  expectClosed(reconstruct(points), points, 1, 0);
}

TEST_F(Reconstruction, StaysSoundOnAVeryNoisySphere)
{
  const double spacing = std::sqrt(4.0 * M_PI / 3000.0);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    const Positions points = noisySphere(3000, 0.3 * spacing, seed);
    const MeshFacts facts = expectSound(reconstruct(points), points);
    EXPECT_EQ(facts.components, 1u);
    EXPECT_LE(facts.boundary_edges, 150u);
    EXPECT_LE(facts.free_vertices, 60u);
  }
}

TEST_F(Reconstruction, LeavesOutliersFree)
{
  const Positions surface = fibonacciSphere(2000);
  const double spacing = std::sqrt(4.0 * M_PI / 2000.0);
  const double reach = 5.0; // in spacings; a new edge is at most four long
  Positions points = surface;
  RandomSource random(5);
  while (points.size() < 2100) {
    const Position outlier(random.uniform(-1.5, 1.5),
                           random.uniform(-1.5, 1.5),
                           random.uniform(-1.5, 1.5));
    if (std::abs(outlier.norm() - 1.0) > reach * spacing)
      points.push_back(outlier);
  }
  const Triangles triangles = reconstruct(points);
  const std::set<index_t> used = usedPoints(triangles);
  EXPECT_EQ(used.size(), 2000u);
  EXPECT_EQ(*used.rbegin(), 1999);
  const MeshFacts facts = expectSound(triangles, points);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_LE(facts.boundary_edges, 12u); // outliers close by may be in the way
}

TEST_F(Reconstruction, OutliersNextToASurfaceLeaveItSound)
{
  Positions points = fibonacciSphere(2000);
  RandomSource random(5);
  for (int i = 0; i < 100; ++i)
    points.emplace_back(random.uniform(-1.2, 1.2),
                        random.uniform(-1.2, 1.2),
                        random.uniform(-1.2, 1.2));
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_GE(facts.used_vertices, 1990u);
}

TEST_F(Reconstruction, LeavesAHoleMuchWiderThanTheSpacingOpen)
{
  Positions points;
  for (const Position& point : fibonacciSphere(3000))
    if (point.z() < 0.9)
      points.push_back(point);
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.boundary_loops.size(), 1u);
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_EQ(facts.free_vertices, 0u);
}

TEST_F(Reconstruction, DoesNotDependOnTheScale)
{
  const Positions points = bumpySphere(1000);
  const Triangles expected = reconstruct(points);
  // Powers of two: rounding is the same, so the triangles must be.
  for (const double factor : {std::ldexp(1.0, -13), std::ldexp(1.0, 20)})
    EXPECT_EQ(reconstruct(scaled(points, factor)), expected) << factor;
}

TEST_F(Reconstruction, StaysSoundFarFromTheOrigin)
{
  const Positions points =
      shifted(scaled(fibonacciSphere(1500), 4.0), {1e5, -1e5, 1e5});
  expectSound(reconstruct(points), points);
}

TEST_F(Reconstruction, MakesASingleTetrahedron)
{
  completion_.setMinimumInternalPoints(0);
  const Positions points = tetrahedron().vertices;
  expectClosed(reconstruct(points), points, 1, 0);
}

} // namespace
} // namespace pcl::ccaa::test
