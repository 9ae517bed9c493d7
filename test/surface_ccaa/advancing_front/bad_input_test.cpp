// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: input that ProjectionCompletion cannot use.
#include "completion_helpers.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

class BadInput : public CompletionTest {
protected:
  void
  setInput(const Shape& given)
  {
    completion_.setInputCloud(toCloud(given.vertices));
    completion_.setPartialMesh(std::make_shared<PolygonMesh>(toPolygonMesh(given)));
  }

  void
  setCloud(const Positions& points)
  {
    completion_.setInputCloud(toCloud(points));
  }
};

TEST_F(BadInput, APartialMeshOfAnotherCloudIsAnError)
{
  setInput(icosphere(1));
  setCloud(icosphere(2).vertices);
  expectError("42 points");
}

TEST_F(BadInput, ACornerBeyondTheCloudIsAnError)
{
  Shape given = icosphere(1);
  given.triangles[3][1] = 42;
  setInput(given);
  expectError("partial mesh");
}

TEST_F(BadInput, ANegativeCornerIsAnError)
{
  Shape given = icosphere(1);
  given.triangles[3][1] = -1;
  setInput(given);
  expectError("partial mesh");
}

TEST_F(BadInput, ARepeatedCornerIsAnError)
{
  Shape given = icosphere(1);
  given.triangles[3][1] = given.triangles[3][0];
  setInput(given);
  expectError("partial mesh");
}

TEST_F(BadInput, APolygonWithTwoCornersIsAnError)
{
  const Shape given = icosphere(1);
  PolygonMesh mesh = toPolygonMesh(given);
  mesh.polygons[3].vertices.resize(2);
  setCloud(given.vertices);
  completion_.setPartialMesh(std::make_shared<PolygonMesh>(mesh));
  expectError("partial mesh");
}

TEST_F(BadInput, ACornerThatIsNotFiniteIsAnError)
{
  Shape given = icosphere(1);
  given.vertices[7].y() = std::numeric_limits<double>::quiet_NaN();
  setInput(given);
  expectError("not finite");
}

TEST_F(BadInput, ThreeTrianglesOnAnEdgeAreAnError)
{
  setInput(threeOnEdge());
  expectError("more than two triangles");
}

TEST_F(BadInput, ATriangleGivenTwiceIsAnError)
{
  Shape given = icosphere(1);
  given.triangles.push_back(given.triangles.front());
  setInput(given);
  expectError("partial mesh");
}

TEST_F(BadInput, ASingleTriangleGivenTwiceIsAnError)
{
  setInput({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}});
  expectError("partial mesh");
}

TEST_F(BadInput, TheTwoSidesOfATriangleAreAnError)
{
  setInput({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  expectError("partial mesh");
}

TEST_F(BadInput, ABowTieIsAnError)
{
  setInput(bowTie());
  expectError("more than one fan");
}

TEST_F(BadInput, TwoClosedFansAtAPointAreAnError)
{
  setInput(twoFansAtApex());
  expectError("more than one fan");
}

TEST_F(BadInput, InconsistentWindingIsAnError)
{
  Shape given = icosphere(1);
  std::swap(given.triangles[3][0], given.triangles[3][1]);
  setInput(given);
  expectError("wound differently");
}

TEST_F(BadInput, AMoebiusBandIsAnError)
{
  setInput(moebiusBand(12));
  expectError("wound differently");
}

TEST_F(BadInput, AnIndexOutsideTheCloudIsAnError)
{
  for (const index_t index : {-1, 100, std::numeric_limits<index_t>::max()}) {
    completion_.setIndices(std::make_shared<Indices>(Indices{0, 1, 2, index}));
    setCloud(fibonacciSphere(100));
    expectError("outside the cloud");
  }
}

TEST_F(BadInput, NeighborsOutOfRangeAreAnError)
{
  setCloud(fibonacciSphere(100));
  for (const unsigned int neighbors : {0u, 5u, 65u}) {
    completion_.setNumberOfNeighbors(neighbors);
    expectError("neighbors");
  }
}

TEST_F(BadInput, SupportOutOfRangeIsAnError)
{
  setCloud(fibonacciSphere(100));
  for (const double support : {-1.0, 0.4, 101.0, std::nan("")}) {
    completion_.setSupport(support);
    expectError("support");
  }
}

TEST_F(BadInput, SmoothFoldOutOfRangeIsAnError)
{
  setCloud(fibonacciSphere(100));
  for (const double fold : {-0.1, 3.2, std::nan("")}) {
    completion_.setSmoothFold(fold);
    expectError("smooth fold");
  }
}

TEST_F(BadInput, LargestFoldOutOfRangeIsAnError)
{
  setCloud(fibonacciSphere(100));
  for (const double fold : {-0.1, 3.2, std::nan("")}) {
    completion_.setLargestFold(fold);
    expectError("largest fold");
  }
}

TEST_F(BadInput, TheEndsOfTheRangesAreNoError)
{
  for (const unsigned int neighbors : {6u, 64u})
    for (const double fold : {0.0, M_PI}) {
      completion_.setNumberOfNeighbors(neighbors);
      completion_.setSupport(neighbors == 6 ? 0.5 : 100.0);
      completion_.setSmoothFold(fold);
      completion_.setLargestFold(M_PI - fold);
      const Positions points = fibonacciSphere(60);
      expectSound(reconstruct(points), points);
    }
}

TEST_F(BadInput, UpToTwoPointsAreAnError)
{
  for (const std::size_t count : {0u, 1u, 2u}) {
    Positions points;
    for (std::size_t i = 0; i < count; ++i)
      points.emplace_back(1.0 + double(i), 2.0, 3.0);
    setCloud(points);
    expectError("usable points");
  }
}

TEST_F(BadInput, OnlyNonFinitePointsAreAnError)
{
  setCloud(Positions(50, Position(std::numeric_limits<double>::quiet_NaN(), 0, 0)));
  expectError("usable points");
}

TEST_F(BadInput, OnlyOnePlaceIsAnError)
{
  setCloud(Positions(5000, Position(1, 1, 1)));
  expectError("usable points");
}

TEST_F(BadInput, PointsOnALineGiveNothing)
{
  EXPECT_TRUE(reconstruct(lineCloud(200)).empty());
}

TEST_F(BadInput, ThreePointsGiveOneTriangleWhenRegionsMayBeSmall)
{
  completion_.setMinimumInternalPoints(0);
  EXPECT_EQ(reconstruct({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 1u);
}

TEST_F(BadInput, FewPointsDoNoHarm)
{
  for (const std::size_t minimum : {0u, 1u, 10u}) {
    completion_.setMinimumInternalPoints(minimum);
    for (std::size_t count = 3; count < 30; ++count) {
      const Positions points = fibonacciSphere(count);
      expectSound(reconstruct(points), points);
    }
  }
}

Positions
volumeOfPoints()
{
  Positions points;
  for (int i = 0; i < 12 * 12 * 12; ++i)
    points.emplace_back(i % 12, i / 12 % 12, i / 144);
  return points;
}

TEST_F(BadInput, AVolumeOfPointsGivesASoundResult)
{
  const Positions points = volumeOfPoints();
  expectSound(reconstruct(points), points);
}

TEST_F(BadInput, AVolumeOfIrregularPointsGivesAnIcadm)
{
  const Positions points = withNoise(volumeOfPoints(), 0.3);
  const Triangles triangles = reconstruct(points);
  EXPECT_TRUE(isIcadm(triangles, points.size()));
  EXPECT_TRUE(isConsistentlyWound(triangles));
}

TEST_F(BadInput, AVolumeOfIrregularPointsGivesNoCrossingTriangles)
{
  const Positions points = withNoise(volumeOfPoints(), 0.1);
  EXPECT_EQ(*factsOf(reconstruct(points), points).self_intersections, 0u);
}

TEST_F(BadInput, AFlatGridGivesASoundResult)
{
  const Positions points = grid(25, 25).vertices;
  const MeshFacts facts = expectSound(reconstruct(points), points);
  EXPECT_EQ(facts.triangles, 24u * 24u * 2u);
}

TEST_F(BadInput, ExtremeCoordinatesDoNoHarm)
{
  for (const double size : {1e-30, 1e-18, 1e15, 1e30}) {
    SCOPED_TRACE(size);
    const Positions points = scaled(fibonacciSphere(300), size);
    const Triangles triangles = reconstruct(points);
    EXPECT_TRUE(isIcadm(triangles, points.size()));
  }
}

TEST_F(BadInput, DegenerateGivenTrianglesDoNoHarm)
{
  Shape given = grid(10, 10);
  given.vertices[44] = given.vertices[45];
  given.vertices[55] = 0.5 * (given.vertices[54] + given.vertices[56]);
  given = withoutTriangles(given, {20, 21, 60, 61, 62, 100});
  given = filteredToIcadm(given, 0);
  EXPECT_TRUE(keepsGiven(given.triangles, complete(given)));
}

TEST_F(BadInput, SelfIntersectingGivenTrianglesAreKept)
{
  Shape given = joined(grid(12, 12), translated(grid(12, 12), {0.3, 0.4, 0.0}));
  for (std::size_t v = 144; v < 288; ++v)
    given.vertices[v].z() = 0.3 * (given.vertices[v].x() - 5.9);
  given = withoutPatches(given, 4, 1, 9);
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  EXPECT_TRUE(isIcadm(triangles, given.vertices.size()));
}

} // namespace
} // namespace pcl::ccaa::test
