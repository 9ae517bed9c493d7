// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what PCL's reconstruct() would crash on, for all classes.
#include <pcl/search/organized.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/projection_completion.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"

namespace pcl::ccaa::test {
namespace {

using Organized = search::OrganizedNeighbor<PointXYZ>;

/** \brief What \a run prints as errors. */
template <typename Run>
std::string
errorsOf(const Run& run)
{
  console::setVerbosityLevel(console::L_ERROR);
  ::testing::internal::CaptureStderr();
  run();
  console::setVerbosityLevel(console::L_ALWAYS);
  return ::testing::internal::GetCapturedStderr();
}

/** \brief Both ways to reconstruct give nothing, with one line of an error each. */
template <typename Algorithm>
void
expectNothingButAnError(Algorithm& algorithm, const std::string& message)
{
  PolygonMesh mesh;
  mesh.polygons.resize(1);
  std::vector<Vertices> polygons(1);
  const std::string expected = "::reconstruct] " + message;
  for (const std::string& errors :
       {errorsOf([&] { algorithm.reconstruct(mesh); }),
        errorsOf([&] { algorithm.reconstruct(polygons); })}) {
    EXPECT_NE(errors.find(expected), std::string::npos) << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  }
  EXPECT_TRUE(mesh.polygons.empty());
  EXPECT_TRUE(polygons.empty());
}

template <typename Algorithm>
class CheckedConstructions : public ::testing::Test {
protected:
  Algorithm algorithm_;
};

using Algorithms = ::testing::Types<GreedyStart<PointXYZ>,
                                    ProjectionCompletion<PointXYZ>,
                                    ConsecutiveReconstruction<PointXYZ>>;
TYPED_TEST_SUITE(CheckedConstructions, Algorithms, );

TYPED_TEST(CheckedConstructions, GiveNothingWithoutACloud)
{
  expectNothingButAnError(this->algorithm_, "no input cloud");
}

TYPED_TEST(CheckedConstructions, GiveNothingForAnOrganisedSearchOfAPlainCloud)
{
  this->algorithm_.setInputCloud(toCloud(fibonacciSphere(200)));
  this->algorithm_.setSearchMethod(pcl::make_shared<Organized>());
  expectNothingButAnError(this->algorithm_, "the search method OrganizedNeighbor");
}

TEST(ConsecutiveReconstruction, MeasuresNothingForAnOrganisedSearchOfAPlainCloud)
{
  ConsecutiveReconstruction<PointXYZ> chain;
  chain.setInputCloud(toCloud(fibonacciSphere(200)));
  chain.setSearchMethod(pcl::make_shared<Organized>());
  std::string errors = errorsOf([&] { EXPECT_EQ(chain.measureSpeedup().points, 0u); });
  EXPECT_NE(errors.find("::measureSpeedup] the search"), std::string::npos) << errors;
}

/** PCL's algorithms get some of the points as a plain cloud; here a corner is missing.
 */
TEST(ConsecutiveReconstruction, TakesAnOrganisedSearchFromAStartThatGetsAPlainCloud)
{
  const auto cloud = pcl::make_shared<PointCloud<PointNormal>>(10, 10);
  const auto selection = pcl::make_shared<Indices>();
  for (index_t i = 1; i < 100; ++i) {
    PointNormal& point = (*cloud)[static_cast<std::size_t>(i)];
    point.getVector3fMap() << 0.1F * float(i % 10), 0.1F * float(i / 10), 1.0F;
    point.getNormalVector3fMap() << 0.0F, 0.0F, -1.0F;
    selection->push_back(i);
  }
  const auto start = pcl::make_shared<GreedyProjectionTriangulation<PointNormal>>();
  start->setSearchRadius(0.3);
  start->setMu(2.5);
  start->setSearchMethod(pcl::make_shared<search::OrganizedNeighbor<PointNormal>>());
  ConsecutiveReconstruction<PointNormal> chain;
  chain.setStartAlgorithm(start);
  chain.setInputCloud(cloud);
  chain.setIndices(selection);
  std::vector<Vertices> polygons;
  const std::string errors = errorsOf([&] { chain.reconstruct(polygons); });
  EXPECT_EQ(errors, "");
  EXPECT_FALSE(polygons.empty());
}

} // namespace
} // namespace pcl::ccaa::test
