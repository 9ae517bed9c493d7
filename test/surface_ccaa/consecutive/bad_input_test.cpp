// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: chains with bad clouds, bad parts and cancelling.
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "chain_fixture.h"

#include <limits>
#include <set>
#include <stdexcept>

namespace pcl::ccaa::test {
namespace {

using ConsecutiveBadInput = ConsecutiveTest;
using ConsecutiveBadParts = ConsecutiveTest;
using ConsecutiveCancelling = ConsecutiveTest;

TEST_F(ConsecutiveBadInput, UpToTwoPointsGiveNothing)
{
  for (const std::size_t count : {0u, 1u, 2u}) {
    EXPECT_TRUE(reconstruct(Positions(count, Position(1, 2, 3))).empty());
    PolygonMesh mesh;
    mesh.polygons.push_back(polygon({0, 1, 2}));
    chain_.reconstruct(mesh);
    EXPECT_TRUE(mesh.polygons.empty());
    EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, count);
  }
}

TEST_F(ConsecutiveBadInput, NoCloudGivesNothing)
{
  Polygons polygons = {polygon({0, 1, 2})};
  chain_.reconstruct(polygons);
  EXPECT_TRUE(polygons.empty());
  EXPECT_EQ(chain_.measureSpeedup().points, 0u);
}

TEST_F(ConsecutiveBadInput, OnlyNonFinitePointsGiveNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(reconstruct(Positions(10, Position(nan, 0, nan))).empty());
  EXPECT_EQ(chain_.getReport().points, 0u);
}

TEST_F(ConsecutiveBadInput, PointsOnALineGiveNothing)
{
  EXPECT_TRUE(reconstruct(lineCloud(100)).empty());
}

TEST_F(ConsecutiveBadInput, IdenticalPointsGiveNothing)
{
  EXPECT_TRUE(reconstruct(Positions(100000, Position(1, 1, 1))).empty());
}

TEST_F(ConsecutiveBadInput, AnIndexOutsideTheCloudGivesNothing)
{
  for (const index_t bad : {500, -1}) {
    chain_.setIndices(std::make_shared<Indices>(Indices{0, 1, 2, bad}));
    EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
  }
}

TEST_F(ConsecutiveBadInput, AnEmptySelectionGivesNothing)
{
  chain_.setIndices(std::make_shared<Indices>());
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
}

TEST_F(ConsecutiveBadParts, AMissingStartIsAnError)
{
  chain_.setStartAlgorithm(nullptr);
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
  EXPECT_EQ(base_->given_points, 0u);
}

TEST_F(ConsecutiveBadParts, MoreStartsThanLabelsAreAnError)
{
  for (int i = 0; i < 255; ++i)
    chain_.addStartAlgorithm(chain_.getStartAlgorithms()[0]);
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
}

TEST_F(ConsecutiveBadParts, ImpossiblePolygonsOfAStartAreLeftOut)
{
  chain_.setFilter(openFilter());
  chain_.setStartAlgorithm(startGiving({polygon({0, 1, 2}),
                                        polygon({0, 1, 500}),
                                        polygon({-1, 1, 2}),
                                        polygon({3, 3, 4}),
                                        polygon({5, 6}),
                                        polygon({}),
                                        polygon({7, 8, 9, 7}),
                                        polygon({7, 8, 9, 10})}));
  const Triangles expected = {{0, 1, 2}, {7, 8, 9}, {7, 9, 10}};
  EXPECT_EQ(reconstruct(fibonacciSphere(500)), expected);
  EXPECT_EQ(chain_.getReport().invalid_polygons, 6u);
}

TEST_F(ConsecutiveBadParts, AFilterThatInventsTrianglesIsAnError)
{
  for (const Indices& bad : {Indices{0, 1, 2},
                             Indices{0, 1, 5000},
                             Indices{0, -1, 2},
                             Indices{0, 1},
                             Indices{0, 1, 2, 3}}) {
    chain_.setFilter(std::make_shared<ScriptedFilter>(
        [&bad](PolygonMesh& mesh) { mesh.polygons[7] = polygon(bad); }));
    EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
    EXPECT_EQ(chain_.getReport().points, 0u);
  }
}

TEST_F(ConsecutiveBadParts, AFilterThatRepeatsATriangleIsAnError)
{
  chain_.setFilter(std::make_shared<ScriptedFilter>(
      [](PolygonMesh& mesh) { mesh.polygons.push_back(mesh.polygons[0]); }));
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
}

TEST_F(ConsecutiveBadParts, WhatAFilterDoesToTheCloudHasNoEffect)
{
  const auto cloud = toCloud(fibonacciSphere(500));
  chain_.setFilter(std::make_shared<ScriptedFilter>(
      [](PolygonMesh& mesh) { mesh.cloud = PCLPointCloud2(); }));
  EXPECT_FALSE(reconstruct(cloud).empty());
  PolygonMesh mesh;
  chain_.reconstruct(mesh);
  PCLPointCloud2 expected;
  toPCLPointCloud2(*cloud, expected);
  EXPECT_TRUE(sameCloud(expected, mesh.cloud));
}

TEST_F(ConsecutiveBadParts, TheCloudOfTheOutputSurvivesAnError)
{
  const auto cloud = toCloud(fibonacciSphere(500));
  chain_.setInputCloud(cloud);
  chain_.setFilter(std::make_shared<ScriptedFilter>([](PolygonMesh& mesh) {
    mesh.cloud = PCLPointCloud2();
    mesh.polygons.push_back(mesh.polygons[0]);
  }));
  PolygonMesh mesh;
  chain_.reconstruct(mesh);
  PCLPointCloud2 expected;
  toPCLPointCloud2(*cloud, expected);
  EXPECT_TRUE(mesh.polygons.empty());
  EXPECT_TRUE(sameCloud(expected, mesh.cloud));
}

TEST_F(ConsecutiveBadParts, ABaseThatDoesNotKeepTheTrianglesIsAnError)
{
  const ScriptedCompletion::Script scripts[] = {
      [](Polygons& polygons, const Cloud&) { polygons.pop_back(); },
      [](Polygons& polygons, const Cloud&) { polygons.erase(polygons.begin()); },
      [](Polygons& polygons, const Cloud&) { std::swap(polygons[0], polygons[1]); },
      [](Polygons& polygons, const Cloud&) {
        polygons.push_back(polygon({0, 1, 500}));
      },
      [](Polygons& polygons, const Cloud&) {
        polygons.push_back(polygon({0, 1}));
      },
      [](Polygons& polygons, const Cloud&) { polygons.clear(); }};
  for (const auto& script : scripts) {
    chain_.setBaseAlgorithm(std::make_shared<ScriptedCompletion>(script));
    EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
    EXPECT_EQ(chain_.getReport().stages.size(), 0u);
    EXPECT_FALSE(chain_.getReport().cancelled);
  }
}

TEST_F(ConsecutiveBadParts, ABaseMayTurnTriangles)
{
  chain_.setBaseAlgorithm(
      std::make_shared<ScriptedCompletion>([](Polygons& polygons, const Cloud&) {
        for (Vertices& polygon : polygons)
          std::swap(polygon.vertices[0], polygon.vertices[2]);
      }));
  EXPECT_FALSE(reconstruct(fibonacciSphere(500)).empty());
}

TEST_F(ConsecutiveBadParts, NoExceptionOfAPartComesThrough)
{
  const auto fail = [](auto&&...) -> Polygons { throw std::runtime_error("no"); };
  Chain chain;
  chain.setInputCloud(toCloud(fibonacciSphere(500)));
  Polygons polygons;
  chain.setStartAlgorithm(std::make_shared<ScriptedStart>(fail));
  EXPECT_NO_THROW(chain.reconstruct(polygons));
  EXPECT_TRUE(polygons.empty());
  chain = Chain();
  chain.setInputCloud(toCloud(fibonacciSphere(500)));
  chain.setFilter(std::make_shared<ScriptedFilter>([&](PolygonMesh&) { throw 7; }));
  EXPECT_NO_THROW(chain.reconstruct(polygons));
  EXPECT_TRUE(polygons.empty());
  chain.setFilter(nullptr);
  chain.setBaseAlgorithm(std::make_shared<ScriptedCompletion>(
      [&](Polygons&, const Cloud&) { throw std::bad_alloc(); }));
  EXPECT_NO_THROW(chain.reconstruct(polygons));
  EXPECT_TRUE(polygons.empty());
  EXPECT_EQ(chain.measureSpeedup().speedup, 0);
}

TEST_F(ConsecutiveBadParts, PartsGetTheirOwnMeshBackAfterAnException)
{
  const auto own_mesh = std::make_shared<PolygonMesh>();
  const auto base = std::make_shared<ScriptedCompletion>(
      [](Polygons&, const Cloud&) { throw std::runtime_error("no"); });
  base->setPartialMesh(own_mesh);
  base->setNumberOfThreads(5);
  chain_.getFilter()->setInputMesh(own_mesh);
  chain_.setBaseAlgorithm(base);
  EXPECT_TRUE(reconstruct(fibonacciSphere(500)).empty());
  EXPECT_EQ(base->getPartialMesh(), own_mesh);
  EXPECT_EQ(base->getNumberOfThreads(), 5u);
  EXPECT_EQ(chain_.getFilter()->getInputMesh(), own_mesh);
}

TEST_F(ConsecutiveBadInput, AOneSidedSurfaceIsNotCompleted)
{
  const Shape band = moebiusBand(60);
  const auto filter = std::make_shared<UmbrellaFilter>();
  filter->setMinimumInternalPoints(0);
  filter->setLargestTwistShare(0);
  chain_.setFilter(filter);
  chain_.setStartAlgorithm(startGiving(toPolygons(band.triangles)));
  EXPECT_TRUE(sameUnorientedTriangles(band.triangles, reconstruct(band.vertices)));
  EXPECT_EQ(chain_.getReport().stages.size(), 1u);
  EXPECT_EQ(base_->given_points, 0u);
}

TEST_F(ConsecutiveBadParts, ASpeedupNeedsABase)
{
  chain_.setInputCloud(toCloud(fibonacciSphere(500)));
  chain_.setBaseAlgorithm(nullptr);
  const SpeedupReport report = chain_.measureSpeedup();
  EXPECT_EQ(report.points, 0u);
  EXPECT_FALSE(report.cancelled);
}

TEST_F(ConsecutiveCancelling, AnyStageCanBeTheLast)
{
  std::set<std::string> all;
  chain_.setComputeNormals(true);
  chain_.setProgressCallback([&](const std::string& stage, double) {
    all.insert(stage);
    return true;
  });
  ASSERT_FALSE(reconstruct(bumpySphere(5000)).empty());
  for (const char* known :
       {"start", "start: edges", "filter: umbrella", "base: filling"})
    EXPECT_EQ(all.count(known), 1u) << known;
  for (const std::string& last : all) {
    chain_.setProgressCallback(
        [&](const std::string& stage, double) { return stage != last; });
    EXPECT_TRUE(reconstruct(bumpySphere(5000)).empty()) << last;
    EXPECT_TRUE(chain_.getReport().cancelled) << last;
    EXPECT_FALSE(chain_.getNormals()) << last;
  }
}

TEST_F(ConsecutiveCancelling, AnExceptionFromTheCallbackCancels)
{
  chain_.setProgressCallback(
      [](const std::string&, double) -> bool { throw std::runtime_error("no"); });
  EXPECT_TRUE(reconstruct(bumpySphere(5000)).empty());
  EXPECT_TRUE(chain_.getReport().cancelled);
}

TEST_F(ConsecutiveCancelling, ProgressGoesFromZeroToOneAndNeverBack)
{
  double last = 0;
  bool rises = true;
  chain_.addStartAlgorithm(startGiving({}));
  chain_.setComputeNormals(true);
  chain_.setProgressCallback([&](const std::string&, double fraction) {
    rises = rises && fraction >= last && fraction <= 1;
    last = fraction;
    return true;
  });
  reconstruct(bumpySphere(5000));
  EXPECT_TRUE(rises);
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST_F(ConsecutiveCancelling, CancelsTheMeasurementOfBothRuns)
{
  chain_.setInputCloud(toCloud(bumpySphere(3000)));
  for (const int allowed : {0, 2, 20}) {
    int calls = 0;
    chain_.setProgressCallback(
        [&](const std::string&, double) { return calls++ < allowed; });
    const SpeedupReport report = chain_.measureSpeedup();
    EXPECT_TRUE(report.cancelled) << allowed;
    EXPECT_EQ(report.speedup, 0) << allowed;
  }
}

} // namespace
} // namespace pcl::ccaa::test
