// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of ConsecutiveReconstruction as a PCL class.
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface/organized_fast_mesh.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "chain_fixture.h"
#include "support/shared_data.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::ccaa::test {
namespace {

using ConsecutiveReconstructionTest = ConsecutiveTest;

/** Completes with one more triangle, of three given points. */
ScriptedCompletion::Script
adding(const Indices& corners)
{
  return [corners](Polygons& polygons, const Cloud&) {
    polygons.push_back(polygon(corners));
  };
}

TEST_F(ConsecutiveReconstructionTest, TheBaseGetsTheFilteredTrianglesAndTheWholeCloud)
{
  const auto cloud = toCloud(bumpySphere(3000));
  const Triangles expected = startAndFilter(cloud);
  EXPECT_EQ(reconstruct(cloud), expected);
  EXPECT_GT(expected.size(), 4000u);
  EXPECT_EQ(base_->given_triangles, expected.size());
  EXPECT_EQ(base_->given_points, 3000u);
  EXPECT_EQ(base_->given_indices.size(), 3000u);
}

/** \brief Drops half of what GreedyStart makes. */
class HalvingStart : public GreedyStart<PointXYZ> {
public:
  std::size_t made = 0;

protected:
  void
  performReconstruction(Polygons& polygons) override
  {
    GreedyStart<PointXYZ>::performReconstruction(polygons);
    made = polygons.size();
    polygons.resize(made / 2);
  }
};

TEST_F(ConsecutiveReconstructionTest, WhoDerivesFromAStageWorksWithPolygons)
{
  const auto start = std::make_shared<HalvingStart>();
  chain_.setStartAlgorithm(start);
  chain_.setFilter(nullptr);
  chain_.setBaseAlgorithm(nullptr);
  const Triangles triangles = reconstruct(toCloud(bumpySphere(2000)));
  EXPECT_GT(start->made, 3000u);
  EXPECT_EQ(start->made / 2, triangles.size());
}

TEST_F(ConsecutiveReconstructionTest, ABaseThatFailsLeavesNothing)
{
  const auto base = std::make_shared<ProjectionCompletion<PointXYZ>>();
  base->setSupport(-1.0);
  chain_.setBaseAlgorithm(base);
  EXPECT_TRUE(reconstruct(toCloud(bumpySphere(2000))).empty());
}

TEST_F(ConsecutiveReconstructionTest, StartsWithGreedyStartAndBlockSearch)
{
  const Chain chain;
  const auto& starts = chain.getStartAlgorithms();
  ASSERT_EQ(starts.size(), 1u);
  EXPECT_TRUE(dynamic_cast<GreedyStart<PointXYZ>*>(starts[0].get()));
  EXPECT_TRUE(
      dynamic_cast<search::BlockSearch<PointXYZ>*>(starts[0]->getSearchMethod().get()));
  EXPECT_TRUE(dynamic_cast<UmbrellaFilter*>(chain.getFilter().get()));
}

TEST_F(ConsecutiveReconstructionTest, LabelsSayWhoMadeATriangle)
{
  const auto cloud = toCloud(bumpySphere(2000));
  chain_.setBaseAlgorithm(std::make_shared<ScriptedCompletion>(adding({0, 1, 2})));
  const Triangles triangles = reconstruct(cloud);
  const auto& labels = chain_.getTriangleLabels();
  ASSERT_EQ(labels.size(), triangles.size());
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 1), 1);
  EXPECT_EQ(labels.back(), 1);
  EXPECT_EQ(triangles.back(), (Triangle{0, 1, 2}));
}

TEST_F(ConsecutiveReconstructionTest, TheReportFitsTheResult)
{
  const Triangles triangles = reconstruct(noisySphere(3000, 0.03));
  const ConsecutiveReport& report = chain_.getReport();
  EXPECT_EQ(report.points, 3000u);
  ASSERT_EQ(report.stages.size(), 2u);
  EXPECT_EQ(report.stages[0].name, "start");
  EXPECT_EQ(report.stages[1].name, "base");
  EXPECT_EQ(report.stages[0].triangles + report.stages[1].triangles, triangles.size());
  EXPECT_EQ(report.stages[0].internal_points, report.internal_points);
  EXPECT_GT(report.internalShare(), 0.3);
  EXPECT_GT(report.connectedShare(), report.internalShare());
  EXPECT_EQ(report.free_points, report.points - report.connected_points);
  EXPECT_DOUBLE_EQ(report.startCost(), report.start_seconds / 3000);
  EXPECT_DOUBLE_EQ(report.filterCost(), report.filter_seconds / 3000);
  EXPECT_DOUBLE_EQ(report.baseCost(),
                   report.base_seconds / double(3000 - report.internal_points));
  EXPECT_GE(report.total_seconds,
            report.start_seconds + report.filter_seconds + report.base_seconds);
  EXPECT_FALSE(report.cancelled);
}

TEST_F(ConsecutiveReconstructionTest, TheReportAgreesWithTheUmbrellaFilter)
{
  reconstruct(noisySphere(3000, 0.03));
  const auto filter = std::dynamic_pointer_cast<UmbrellaFilter>(chain_.getFilter());
  EXPECT_EQ(chain_.getReport().internal_points, filter->getReport().internal_points);
  EXPECT_EQ(chain_.getReport().free_points, filter->getReport().free_points);
  // Counted by the chain itself, when the filter is not ours.
  const Triangles expected = startAndFilter(toCloud(noisySphere(3000, 0.03)));
  chain_.setStartAlgorithm(startGiving(toPolygons(expected)));
  chain_.setFilter(openFilter());
  reconstruct(noisySphere(3000, 0.03));
  EXPECT_EQ(chain_.getReport().internal_points, filter->getReport().internal_points);
  EXPECT_EQ(chain_.getReport().free_points, filter->getReport().free_points);
}

TEST_F(ConsecutiveReconstructionTest, CountsThePointsThatTheBaseHasConnected)
{
  chain_.setStartAlgorithm(startGiving({}));
  chain_.setBaseAlgorithm(std::make_shared<ScriptedCompletion>(adding({0, 1, 2})));
  EXPECT_EQ(reconstruct(fibonacciSphere(100)).size(), 1u);
  EXPECT_EQ(chain_.getReport().connected_points, 0u);
  EXPECT_EQ(chain_.getReport().free_points, 97u);
}

TEST_F(ConsecutiveReconstructionTest, WithoutABaseTheFilterHasTheLastWord)
{
  chain_.setBaseAlgorithm(nullptr);
  EXPECT_TRUE(isIcadm(reconstruct(noisySphere(2000, 0.03)), 2000));
  EXPECT_EQ(chain_.getReport().stages.size(), 1u);
}

TEST_F(ConsecutiveReconstructionTest, WithoutAFilterTheStartsMistakesStay)
{
  const Shape shape = threeOnEdge();
  chain_.setFilter(nullptr);
  chain_.setStartAlgorithm(startGiving(toPolygons(shape.triangles)));
  EXPECT_EQ(reconstruct(shape.vertices), shape.triangles);
  EXPECT_EQ(chain_.getReport().internal_points, 0u);
}

TEST_F(ConsecutiveReconstructionTest, QuadsOfAStartBecomeTriangles)
{
  const auto cloud = toCloud(grid(20, 20).vertices);
  cloud->width = cloud->height = 20;
  (*cloud)[0].x = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  const auto organised = std::make_shared<OrganizedFastMesh<PointXYZ>>();
  organised->setTriangulationType(OrganizedFastMesh<PointXYZ>::QUAD_MESH);
  organised->storeShadowedFaces(true); // the sensor lies in the plane
  chain_.setStartAlgorithm(organised);
  EXPECT_EQ(reconstruct(Cloud::ConstPtr(cloud)).size(), (19u * 19 - 1) * 2);
}

TEST_F(ConsecutiveReconstructionTest, BothOverloadsGiveTheSame)
{
  const auto cloud = toCloud(bumpySphere(2000));
  const Triangles expected = reconstruct(cloud);
  PolygonMesh mesh;
  chain_.reconstruct(mesh);
  EXPECT_EQ(toTriangles(mesh.polygons), expected);
  PCLPointCloud2 raw;
  toPCLPointCloud2(*cloud, raw);
  EXPECT_TRUE(sameCloud(raw, mesh.cloud));
}

TEST_F(ConsecutiveReconstructionTest, SameResultForAnyNumberOfThreads)
{
  const auto cloud = toCloud(noisySphere(20000, 0.01));
  chain_.addStartAlgorithm(std::make_shared<GreedyStart<PointXYZ>>());
  chain_.setComputeNormals(true);
  chain_.setNumberOfThreads(1);
  const Triangles expected = reconstruct(cloud);
  const auto labels = chain_.getTriangleLabels();
  const auto normals = chain_.getNormals();
  for (const unsigned int threads : {2u, 7u}) {
    chain_.setNumberOfThreads(threads);
    EXPECT_EQ(reconstruct(cloud), expected) << threads;
    EXPECT_EQ(chain_.getTriangleLabels(), labels) << threads;
    for (std::size_t i = 0; i < normals->size(); ++i)
      ASSERT_EQ(std::memcmp((*normals)[i].data_n,
                            (*chain_.getNormals())[i].data_n,
                            3 * sizeof(float)),
                0);
  }
}

TEST_F(ConsecutiveReconstructionTest, CanBeUsedAgain)
{
  const Positions first = fibonacciSphere(800), second = torusCloud(1200);
  const Triangles expected = reconstruct(first);
  reconstruct(second);
  EXPECT_EQ(chain_.getReport().points, second.size());
  EXPECT_EQ(reconstruct(first), expected);
  EXPECT_EQ(chain_.getReport().stages.size(), 2u);
}

TEST_F(ConsecutiveReconstructionTest, LeavesTheInputAlone)
{
  const Cloud::Ptr cloud = toCloud(withNonFinite(fibonacciSphere(500), 5));
  const Cloud before = *cloud;
  reconstruct(Cloud::ConstPtr(cloud));
  EXPECT_TRUE(sameBytes(*cloud, before));
}

TEST_F(ConsecutiveReconstructionTest, NonFinitePointsReachNoPart)
{
  const Positions points = withNonFinite(fibonacciSphere(1000), 50);
  const auto scripted =
      std::make_shared<ScriptedStart>([](const Cloud& cloud, const Indices& indices) {
        EXPECT_EQ(indices.size(), 950u);
        for (const index_t index : indices)
          EXPECT_TRUE(std::isfinite(cloud[std::size_t(index)].x));
        return Polygons();
      });
  chain_.addStartAlgorithm(scripted);
  chain_.setStartAlgorithm(scripted);
  reconstruct(points);
  EXPECT_EQ(scripted->runs, 1);
  EXPECT_EQ(base_->given_indices.size(), 950u);
  EXPECT_EQ(chain_.getReport().skipped_points, 50u);
  EXPECT_EQ(chain_.getReport().points, 1000u);
  EXPECT_EQ(chain_.getReport().free_points, 1000u);
}

TEST_F(ConsecutiveReconstructionTest, UsesTheChosenIndicesOnly)
{
  const auto cloud = toCloud(fibonacciSphere(2000));
  const auto lower = std::make_shared<Indices>();
  for (index_t i = 0; i < 2000; ++i)
    if ((*cloud)[std::size_t(i)].z < 0)
      lower->push_back(i);
  chain_.setIndices(lower);
  const Triangles triangles = reconstruct(cloud);
  EXPECT_GT(triangles.size(), 1800u);
  for (const Triangle& t : triangles)
    for (const index_t corner : t)
      ASSERT_LT((*cloud)[std::size_t(corner)].z, 0);
  EXPECT_EQ(base_->given_indices, *lower);
  EXPECT_EQ(chain_.getReport().points, lower->size());
  EXPECT_GT(chain_.getReport().connectedShare(), 0.95);
}

TEST_F(ConsecutiveReconstructionTest, ASearchMethodGoesToStartAndBase)
{
  const auto tree = std::make_shared<search::KdTree<PointXYZ>>(false);
  const auto cloud = toCloud(bumpySphere(2000));
  const Triangles expected = reconstruct(cloud);
  EXPECT_EQ(base_->given_tree, nullptr);
  chain_.setSearchMethod(tree);
  EXPECT_TRUE(sameUnorientedTriangles(expected, reconstruct(cloud)));
  EXPECT_EQ(base_->given_tree, tree.get());
  EXPECT_EQ(chain_.getStartAlgorithms()[0]->getSearchMethod(), tree);
}

TEST_F(ConsecutiveReconstructionTest, PartsGetThreadsForTheRunOnly)
{
  const auto own_mesh = std::make_shared<PolygonMesh>();
  base_->setNumberOfThreads(3);
  base_->setPartialMesh(own_mesh);
  chain_.getFilter()->setInputMesh(own_mesh);
  chain_.setNumberOfThreads(2);
  chain_.setProgressCallback([](const std::string&, double) { return true; });
  reconstruct(fibonacciSphere(500));
  EXPECT_EQ(base_->given_threads, 2u);
  EXPECT_EQ(base_->getNumberOfThreads(), 3u);
  EXPECT_FALSE(base_->getProgressCallback());
  EXPECT_EQ(base_->getPartialMesh(), own_mesh);
  EXPECT_EQ(chain_.getFilter()->getInputMesh(), own_mesh);
}

TEST_F(ConsecutiveReconstructionTest, NormalsPointOutwardOnASphere)
{
  const auto cloud = toCloud(withNonFinite(fibonacciSphere(3000), 3));
  chain_.setComputeNormals(true);
  const Triangles triangles = reconstruct(cloud);
  const auto normals = chain_.getNormals();
  ASSERT_TRUE(normals);
  ASSERT_EQ(normals->size(), 3000u);
  EXPECT_FALSE(normals->is_dense);
  std::vector<bool> used(3000, false);
  for (const Triangle& t : triangles)
    for (const index_t corner : t)
      used[std::size_t(corner)] = true;
  for (std::size_t i = 0; i < 3000; ++i) {
    const Eigen::Vector3f normal = (*normals)[i].getNormalVector3fMap();
    if (used[i])
      EXPECT_GT(normal.dot((*cloud)[i].getVector3fMap()), 0.99f) << i;
    else
      EXPECT_TRUE(normal.hasNaN()) << i;
  }
}

TEST_F(ConsecutiveReconstructionTest, NoNormalsUnlessAskedFor)
{
  chain_.setComputeNormals(true);
  reconstruct(fibonacciSphere(500));
  chain_.setComputeNormals(false);
  reconstruct(fibonacciSphere(500));
  EXPECT_FALSE(chain_.getNormals());
}

TEST_F(ConsecutiveReconstructionTest, MeshesTheBunny)
{
  const std::string path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  Shape bunny;
  ASSERT_TRUE(readShape(path, bunny));
  const auto cloud = toCloud(bunny.vertices);
  EXPECT_TRUE(isSubsetOf(startAndFilter(cloud), reconstruct(cloud)));
  EXPECT_GT(chain_.getReport().connectedShare(), 0.99);
}

} // namespace
} // namespace pcl::ccaa::test
