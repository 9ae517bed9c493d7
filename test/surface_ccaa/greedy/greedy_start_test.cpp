// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of GreedyStart as a PCL class.
#include <pcl/io/pcd_io.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <Eigen/Geometry>

#include "start_fixture.h"
#include "support/shared_data.h"

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

namespace pcl::ccaa::test {
namespace {

int
mostTrianglesOnAnEdge(const Triangles& triangles)
{
  std::map<std::pair<index_t, index_t>, int> on_edge;
  int most = 0;
  for (const Triangle& t : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, ++on_edge[std::minmax(t[c], t[(c + 1) % 3])]);
  return most;
}

double
smallestAngle(const Triangles& triangles, const Positions& points)
{
  double smallest = M_PI;
  for (const Triangle& t : triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const Position& p = points[std::size_t(t[c])];
      const Position u = points[std::size_t(t[(c + 1) % 3])] - p;
      const Position v = points[std::size_t(t[(c + 2) % 3])] - p;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  return smallest;
}

TEST_F(GreedyStartTest, ClosesAnEvenSphere)
{
  const Triangles triangles = reconstruct(fibonacciSphere(2000));
  EXPECT_GE(triangles.size(), 3990u); // Euler: 2 N - 4 = 3996
  EXPECT_LE(triangles.size(), 3996u);
}

TEST_F(GreedyStartTest, UsesEveryPointOfATorus)
{
  const Positions points = torusCloud(3000);
  EXPECT_EQ(usedPoints(reconstruct(points)), points.size());
}

/** Corners of a triangle that lie on the upper sheet, -1 near the rim, where a start
 * algorithm may well go around it. */
int
cornersAbove(const Triangle& triangle, const Positions& plate, double middle)
{
  int above = 0;
  for (const index_t corner : triangle) {
    const Position& p = plate[std::size_t(corner)];
    if (p.head<2>().minCoeff() < 0.1 || p.head<2>().maxCoeff() > 0.9)
      return -1;
    above += p.z() > middle;
  }
  return above;
}

TEST_F(GreedyStartTest, KeepsThinPlatesApart)
{
  const double thickness = 0.1; // three times the spacing
  const Positions plate = thinPlateCloud(30, thickness);
  int crossing = 0;
  for (const Triangle& t : reconstruct(plate)) {
    const int above = cornersAbove(t, plate, thickness / 2);
    crossing += above == 1 || above == 2;
  }
  EXPECT_EQ(crossing, 0);
}

TEST_F(GreedyStartTest, NoEdgeHasThreeTriangles)
{
  for (const double noise : {0.0, 0.01, 0.05})
    EXPECT_LE(mostTrianglesOnAnEdge(reconstruct(noisySphere(3000, noise))), 2) << noise;
}

TEST_F(GreedyStartTest, PlainModeObeysTheAngleEverywhere)
{
  const Positions points = bumpySphere(2000);
  start_.setUseCertificates(false);
  start_.setMinimumAngle(0.3);
  EXPECT_GE(smallestAngle(reconstruct(points), points), 0.3 - 1e-6);
}

TEST_F(GreedyStartTest, CertifiedEdgesObeyTheirOwnAngle)
{
  const Positions points = bumpySphere(2000);
  start_.setMinimumAngle(0.3);
  start_.setCertifiedMinimumAngle(0.3);
  EXPECT_GE(smallestAngle(reconstruct(points), points), 0.3 - 1e-6);
}

TEST_F(GreedyStartTest, CertificatesCloseMoreThanThePlainAlgorithm)
{
  const Positions points = bumpySphere(3000);
  const std::size_t certified = reconstruct(points).size();
  start_.setUseCertificates(false);
  EXPECT_GT(certified, reconstruct(points).size());
}

TEST_F(GreedyStartTest, TheSecondPassOnlyAdds)
{
  const Positions points = noisySphere(5000, 0.03);
  const Triangles with = reconstruct(points);
  start_.setSecondPass(false);
  const Triangles without = reconstruct(points);
  EXPECT_TRUE(isSubsetOf(without, with));
  EXPECT_LT(without.size(), with.size());
}

TEST_F(GreedyStartTest, SameTrianglesForAnyNumberOfThreads)
{
  const Positions points = bumpySphere(20000);
  start_.setNumberOfThreads(1);
  const Triangles expected = reconstruct(points);
  for (const unsigned int threads : {2u, 7u}) {
    start_.setNumberOfThreads(threads);
    EXPECT_EQ(reconstruct(points), expected) << threads;
  }
}

TEST_F(GreedyStartTest, AnySearchMethodGivesTheSameTriangles)
{
  const Positions points = bumpySphere(2000);
  const Triangles expected = reconstruct(points);
  start_.setSearchMethod(std::make_shared<pcl::search::KdTree<PointXYZ>>(false));
  EXPECT_TRUE(sameUnorientedTriangles(expected, reconstruct(points)));
  start_.setSearchMethod(std::make_shared<pcl::search::Octree<PointXYZ>>(0.05));
  EXPECT_TRUE(sameUnorientedTriangles(expected, reconstruct(points)));
}

TEST_F(GreedyStartTest, TakesAKdTreeOfItsOwnWhenNoneIsSet)
{
  start_.setSearchMethod(nullptr);
  EXPECT_FALSE(reconstruct(fibonacciSphere(300)).empty());
  EXPECT_NE(start_.getSearchMethod(), nullptr);
}

TEST_F(GreedyStartTest, DoesNotDependOnTheScale)
{
  const Positions points = bumpySphere(2000);
  const Triangles expected = reconstruct(points);
  // Powers of two near 1e-4, 1e6: rounding is the same, so the triangles must be.
  for (const double factor : {std::ldexp(1.0, -13), std::ldexp(1.0, 20)})
    EXPECT_EQ(reconstruct(scaled(points, factor)), expected) << factor;
}

TEST_F(GreedyStartTest, WorksFarFromTheOrigin)
{
  // A step of float there is 0.06, a fifth of the spacing: many points move, few are
  // lost.
  const Positions points =
      shifted(scaled(fibonacciSphere(2000), 4.0), {1e5, -1e5, 1e5});
  EXPECT_GE(usedPoints(reconstruct(points)), 1900u);
}

TEST_F(GreedyStartTest, EachPointFiveTimesGivesTheSurfaceOfThePointsOnce)
{
  const Positions points = fibonacciSphere(500);
  const Triangles expected = reconstruct(points);
  EXPECT_TRUE(
      sameUnorientedTriangles(expected, reconstruct(withDuplicates(points, 5))));
  EXPECT_EQ(start_.getReport().duplicate_points, 2000u);
}

TEST_F(GreedyStartTest, NonFinitePointsGetNoTriangle)
{
  const Positions points = withNonFinite(fibonacciSphere(1000), 50);
  for (const Triangle& t : reconstruct(points))
    for (const index_t corner : t)
      ASSERT_TRUE(points[std::size_t(corner)].allFinite());
  EXPECT_EQ(start_.getReport().skipped_points, 50u);
}

TEST_F(GreedyStartTest, UsesTheChosenIndicesOnlyAndSpeaksOfTheCloud)
{
  const Cloud::Ptr cloud = toCloud(fibonacciSphere(1000));
  const auto lower = std::make_shared<Indices>();
  for (index_t i = 0; i < 1000; ++i)
    if ((*cloud)[std::size_t(i)].z < 0)
      lower->push_back(i);
  start_.setIndices(lower);
  const Triangles triangles = reconstruct(Cloud::ConstPtr(cloud));
  EXPECT_GT(usedPoints(triangles), lower->size() * 9 / 10);
  for (const Triangle& t : triangles)
    for (const index_t corner : t)
      ASSERT_LT((*cloud)[std::size_t(corner)].z, 0);
}

TEST_F(GreedyStartTest, TakesAnOrganisedCloud)
{
  const Cloud::Ptr cloud = toCloud(terrainCloud(20));
  cloud->width = 20;
  cloud->height = 20;
  start_.setSearchMethod(nullptr);
  EXPECT_GT(reconstruct(Cloud::ConstPtr(cloud)).size(), 600u);
}

TEST_F(GreedyStartTest, BothOverloadsGiveTheSameTriangles)
{
  const Triangles expected = reconstruct(fibonacciSphere(500));
  PolygonMesh mesh;
  start_.reconstruct(mesh);
  EXPECT_EQ(toTriangles(mesh.polygons), expected);
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 500u);
}

TEST_F(GreedyStartTest, CanBeUsedAgain)
{
  const Positions first = fibonacciSphere(500), second = torusCloud(800);
  const Triangles expected = reconstruct(first);
  reconstruct(second);
  EXPECT_EQ(reconstruct(first), expected);
}

TEST_F(GreedyStartTest, LeavesTheInputAlone)
{
  const Cloud::Ptr cloud = toCloud(withNonFinite(fibonacciSphere(300), 5));
  const Cloud before = *cloud;
  reconstruct(Cloud::ConstPtr(cloud));
  EXPECT_TRUE(sameBytes(*cloud, before));
}

TEST_F(GreedyStartTest, ReadsAPcdFile)
{
  const Cloud::Ptr cloud(new Cloud);
  ASSERT_EQ(io::loadPCDFile(testData("sphere.pcd"), *cloud), 0);
  EXPECT_EQ(usedPoints(reconstruct(Cloud::ConstPtr(cloud))), cloud->size());
}

TEST_F(GreedyStartTest, MeshesTheBunny)
{
  const std::string path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  Shape bunny;
  ASSERT_TRUE(readShape(path, bunny));
  EXPECT_GT(usedPoints(reconstruct(bunny.vertices)), 35900u);
}

TEST_F(GreedyStartTest, CancellingLeavesAnEmptyResult)
{
  for (const std::string stop : {"neighbors", "edges", "second pass", "polygons"}) {
    bool reached = false;
    start_.setProgressCallback([&](const std::string& stage, double) {
      reached = reached || stage == stop;
      return stage != stop;
    });
    EXPECT_TRUE(reconstruct(bumpySphere(5000)).empty()) << stop;
    EXPECT_TRUE(reached) << stop;
    EXPECT_TRUE(start_.getReport().cancelled) << stop;
  }
}

TEST_F(GreedyStartTest, AnExceptionFromTheCallbackCancels)
{
  start_.setProgressCallback([](const std::string& stage, double) -> bool {
    if (stage == "edges")
      throw std::runtime_error("not now");
    return true;
  });
  EXPECT_TRUE(reconstruct(bumpySphere(5000)).empty());
  EXPECT_TRUE(start_.getReport().cancelled);
}

TEST_F(GreedyStartTest, ProgressStaysBetweenZeroAndOne)
{
  bool in_range = true;
  start_.setProgressCallback([&](const std::string&, double fraction) {
    in_range = in_range && fraction >= 0 && fraction <= 1;
    return true;
  });
  reconstruct(bumpySphere(5000));
  EXPECT_TRUE(in_range);
}

} // namespace
} // namespace pcl::ccaa::test
