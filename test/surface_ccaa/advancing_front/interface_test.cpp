// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ProjectionCompletion as a PCL class.
#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/block_search.h>

#include "completion_helpers.h"

#include <limits>
#include <stdexcept>

namespace pcl::ccaa::test {
namespace {

using Interface = CompletionTest;

Shape
bumpyPartialMesh()
{
  return filteredToIcadm(withoutPatches(
      withoutRandomTriangles(noisyIcosphere(4, 0.01), 0.05, 1), 8, 2, 2));
}

TEST_F(Interface, SameTrianglesForAnyNumberOfThreads)
{
  const Shape given = bumpyPartialMesh();
  completion_.setNumberOfThreads(1);
  const Triangles expected = complete(given);
  for (const unsigned int threads : {2u, 7u}) {
    completion_.setNumberOfThreads(threads);
    EXPECT_EQ(complete(given), expected) << threads;
  }
}

TEST_F(Interface, SameReconstructionForAnyNumberOfThreads)
{
  const Positions points = bumpySphere(4000);
  completion_.setNumberOfThreads(1);
  const Triangles expected = reconstruct(points);
  for (const unsigned int threads : {2u, 7u}) {
    completion_.setNumberOfThreads(threads);
    EXPECT_EQ(reconstruct(points), expected) << threads;
  }
}

TEST_F(Interface, AKdTreeGivesTheSameTrianglesAsBlocks)
{
  const Shape given = bumpyPartialMesh();
  completion_.setSearchMethod(std::make_shared<search::BlockSearch<PointXYZ>>());
  const Triangles expected = complete(given);
  completion_.setSearchMethod(std::make_shared<search::KdTree<PointXYZ>>(false));
  EXPECT_EQ(complete(given), expected);
}

TEST_F(Interface, AKdTreeGivesTheSameReconstructionAsBlocks)
{
  const Positions points = bumpySphere(1500);
  completion_.setSearchMethod(std::make_shared<search::BlockSearch<PointXYZ>>());
  const Triangles expected = reconstruct(points);
  completion_.setSearchMethod(std::make_shared<search::KdTree<PointXYZ>>(false));
  EXPECT_EQ(reconstruct(points), expected);
}

TEST_F(Interface, NoSearchMethodGivesTheSameTrianglesAsBlocks)
{
  const Positions points = bumpySphere(1500);
  completion_.setSearchMethod(std::make_shared<search::BlockSearch<PointXYZ>>());
  const Triangles expected = reconstruct(points);
  completion_.setSearchMethod(nullptr);
  EXPECT_EQ(reconstruct(points), expected);
}

TEST_F(Interface, BothOverloadsGiveTheSameTriangles)
{
  const Triangles expected = complete(bumpyPartialMesh());
  PolygonMesh mesh;
  completion_.reconstruct(mesh);
  EXPECT_EQ(toTriangles(mesh.polygons), expected);
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, completion_.getInputCloud()->size());
}

TEST_F(Interface, CanBeUsedAgainWithAndWithoutAPartialMesh)
{
  const Shape given = bumpyPartialMesh();
  const Positions points = bumpySphere(1000);
  const Triangles completed = complete(given), reconstructed = reconstruct(points);
  EXPECT_EQ(complete(given), completed);
  EXPECT_EQ(reconstruct(points), reconstructed);
}

TEST_F(Interface, AnErrorDoesNotSpoilTheNextRun)
{
  const Shape given = bumpyPartialMesh();
  const Triangles expected = complete(given);
  EXPECT_TRUE(complete({given.vertices, {{0, 1, 1}}}).empty());
  EXPECT_EQ(complete(given), expected);
}

TEST_F(Interface, LeavesInputAlone)
{
  const Shape given = bumpyPartialMesh();
  const Cloud::Ptr cloud = toCloud(given.vertices);
  const Cloud before = *cloud;
  const auto mesh = std::make_shared<PolygonMesh>(toPolygonMesh(given));
  completion_.setInputCloud(cloud);
  completion_.setPartialMesh(mesh);
  run();
  EXPECT_TRUE(sameBytes(*cloud, before));
  EXPECT_EQ(toTriangles(mesh->polygons), given.triangles);
}

TEST_F(Interface, NonFinitePointsGetNoTriangle)
{
  const Positions points = withNonFinite(fibonacciSphere(1500), 40);
  const Triangles triangles = reconstruct(points);
  EXPECT_GT(triangles.size(), 2500u);
  for (const index_t used : usedPoints(triangles))
    ASSERT_TRUE(points[std::size_t(used)].allFinite());
}

TEST_F(Interface, NonFinitePointsDoNotChangeThePartialMesh)
{
  const Shape whole = icosphere(3);
  Shape given = withoutPatches(whole, 3, 1, 5);
  const std::set<index_t> used = usedPoints(given.triangles);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t v = 0; v < given.vertices.size(); ++v)
    if (used.count(static_cast<index_t>(v)) == 0)
      given.vertices[v].setConstant(nan);
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  EXPECT_EQ(usedPoints(triangles), used);
}

TEST_F(Interface, UsesTheChosenIndicesOnlyAndSpeaksOfTheCloud)
{
  const Positions points = fibonacciSphere(1500);
  const auto lower = std::make_shared<Indices>();
  for (std::size_t i = points.size(); i-- > 0;)
    if (points[i].z() < 0)
      lower->push_back(static_cast<index_t>(i));
  completion_.setIndices(lower);
  const std::set<index_t> used = usedPoints(reconstruct(points));
  EXPECT_EQ(used, std::set<index_t>(lower->begin(), lower->end()));
}

TEST_F(Interface, IndicesThatRepeatChangeNothing)
{
  const Positions points = bumpySphere(600);
  const Triangles expected = reconstruct(points);
  const auto twice = std::make_shared<Indices>();
  for (index_t i = 0; i < 600; ++i)
    twice->insert(twice->end(), {i, i});
  completion_.setIndices(twice);
  EXPECT_EQ(reconstruct(points), expected);
}

TEST_F(Interface, EachPlaceIsUsedOnce)
{
  const Positions points = fibonacciSphere(600);
  const Triangles once = reconstruct(points);
  const Triangles triangles = reconstruct(withDuplicates(points, 3));
  EXPECT_EQ(triangles.size(), once.size());
  EXPECT_EQ(usedPoints(triangles).size(), points.size());
}

TEST_F(Interface, CopiesOfGivenPointsGetNoTriangle)
{
  Shape given = withoutPatches(icosphere(3), 2, 1, 5);
  const std::size_t count = given.vertices.size();
  const std::set<index_t> used = usedPoints(given.triangles);
  for (const index_t point : used)
    given.vertices.push_back(given.vertices[std::size_t(point)]);
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  EXPECT_LT(*usedPoints(triangles).rbegin(), static_cast<index_t>(count));
}

TEST_F(Interface, TakesAnOrganisedCloud)
{
  const Cloud::Ptr cloud = toCloud(terrainCloud(20));
  cloud->width = 20;
  cloud->height = 20;
  completion_.setInputCloud(cloud);
  EXPECT_GT(run().size(), 650u);
}

TEST_F(Interface, TakesPolygonsWithFourCorners)
{
  const Shape floor = grid(8, 8);
  auto mesh = std::make_shared<PolygonMesh>();
  for (std::size_t t = 0; t + 1 < floor.triangles.size(); t += 4) {
    const Triangle &first = floor.triangles[t], &second = floor.triangles[t + 1];
    Vertices square;
    square.vertices = {first[0], first[1], first[2], second[2]};
    mesh->polygons.push_back(square);
  }
  mesh->polygons.resize(1);
  completion_.setInputCloud(toCloud(floor.vertices));
  completion_.setPartialMesh(mesh);
  const Triangles triangles = run();
  ASSERT_GE(triangles.size(), 2u);
  EXPECT_TRUE(sameTriangles({floor.triangles[0], floor.triangles[1]},
                            {triangles[0], triangles[1]}) ||
              sameTriangles(reversed({floor.triangles[0], floor.triangles[1]}),
                            {triangles[0], triangles[1]}));
}

TEST_F(Interface, CancellingLeavesAnEmptyResult)
{
  const Positions points = bumpySphere(4000);
  for (const std::string stop :
       {"partial mesh", "growth", "orientation", "outer side"}) {
    SCOPED_TRACE(stop);
    bool reached = false;
    completion_.setProgressCallback([&](const std::string& stage, double) {
      reached = reached || stage == stop;
      return stage != stop;
    });
    EXPECT_TRUE(reconstruct(points).empty());
    EXPECT_TRUE(reached);
    EXPECT_TRUE(completion_.getReport().cancelled);
  }
}

TEST_F(Interface, GrowthAsksMoreOftenTheMoreItGrows)
{
  const auto calls = [&](std::size_t points) {
    int count = 0;
    completion_.setProgressCallback([&](const std::string& stage, double) {
      count += stage == "neighbors" ? 1 : 0; // reported last before the only region
      return true;
    });
    EXPECT_FALSE(reconstruct(bumpySphere(points)).empty());
    return count;
  };
  const int few = calls(2000);
  EXPECT_GT(few, 10);
  EXPECT_GT(calls(8000), 3 * few);
}

TEST_F(Interface, CancellingAnywhereLeavesAnEmptyResult)
{
  const Shape given = bumpyPartialMesh();
  for (const bool keep : {true, false}) {
    completion_.setKeepGiven(keep);
    int calls = 0;
    completion_.setProgressCallback([&](const std::string&, double) {
      ++calls;
      return true;
    });
    ASSERT_FALSE(complete(given).empty());
    const int all_calls = calls;
    for (int last = 0; last < all_calls; last += std::max(1, all_calls / 12)) {
      SCOPED_TRACE(last);
      calls = 0;
      completion_.setProgressCallback(
          [&](const std::string&, double) { return calls++ < last; });
      EXPECT_TRUE(complete(given).empty());
      EXPECT_TRUE(completion_.getReport().cancelled);
      if (!keep) {
        EXPECT_TRUE(completion_.keptTriangles()->empty());
      }
    }
  }
}

TEST_F(Interface, AnExceptionFromTheCallbackCancels)
{
  completion_.setProgressCallback([](const std::string& stage, double) -> bool {
    if (stage == "orientation")
      throw std::runtime_error("not now");
    return true;
  });
  EXPECT_TRUE(reconstruct(bumpySphere(3000)).empty());
  EXPECT_TRUE(completion_.getReport().cancelled);
}

TEST_F(Interface, ProgressStaysBetweenZeroAndOne)
{
  bool in_range = true;
  completion_.setProgressCallback([&](const std::string&, double fraction) {
    in_range = in_range && fraction >= 0 && fraction <= 1;
    return true;
  });
  complete(bumpyPartialMesh());
  reconstruct(bumpySphere(3000));
  EXPECT_TRUE(in_range);
}

TEST_F(Interface, AWiderSupportClosesAWiderHole)
{
  Positions points;
  for (const Position& point : fibonacciSphere(2000))
    if (point.z() < 0.97)
      points.push_back(point);
  const std::size_t narrow = countBoundaryEdges(reconstruct(points));
  completion_.setSupport(50.0);
  EXPECT_LE(countBoundaryEdges(reconstruct(points)), narrow);
}

} // namespace
} // namespace pcl::ccaa::test
