// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of PCL's greedy projection as the start of a chain.

#include <pcl/surface/gp3.h>

#include <gtest/gtest.h>

#include "chain_fixture.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

using Gp3Start = ConsecutiveTest;

PointCloud<PointNormal>::Ptr
withNormals(const Cloud::ConstPtr& cloud)
{
  const auto result = std::make_shared<PointCloud<PointNormal>>();
  for (const PointXYZ& point : *cloud) {
    PointNormal oriented;
    oriented.getVector3fMap() = point.getVector3fMap();
    oriented.getNormalVector3fMap() = point.getVector3fMap().normalized();
    result->push_back(oriented);
  }
  return result;
}

/** With gp3 set for a sphere of 2000 points, and no base. */
void
startWithGp3(ConsecutiveReconstruction<PointNormal>& chain)
{
  const auto gp3 = std::make_shared<GreedyProjectionTriangulation<PointNormal>>();
  gp3->setSearchRadius(0.2);
  gp3->setMu(3);
  gp3->setMaximumNearestNeighbors(60);
  chain.setStartAlgorithm(gp3);
  chain.setBaseAlgorithm(nullptr);
}

TEST_F(Gp3Start, TakesPclsGreedyProjectionAsStart)
{
  const auto cloud = toCloud(fibonacciSphere(2000));
  ConsecutiveReconstruction<PointNormal> chain;
  startWithGp3(chain);
  chain.setInputCloud(withNormals(cloud));
  Polygons polygons;
  chain.reconstruct(polygons);
  EXPECT_GT(polygons.size(), 3800u);
  EXPECT_TRUE(isIcadm(toTriangles(polygons), 2000));
}

/** gp3 itself fails on both: it takes indices for positions among them. */
TEST_F(Gp3Start, Gp3StartsOnASelectionWithBadPoints)
{
  auto cloud = withNormals(toCloud(fibonacciSphere(2000)));
  (*cloud)[1500].x = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  const auto lower = std::make_shared<Indices>();
  for (index_t i = 1000; i < 2000; ++i)
    lower->push_back(i);
  ConsecutiveReconstruction<PointNormal> chain;
  startWithGp3(chain);
  chain.setInputCloud(cloud);
  chain.setIndices(lower);
  Polygons polygons;
  chain.reconstruct(polygons);
  EXPECT_GT(polygons.size(), 1700u);
  EXPECT_EQ(chain.getReport().skipped_points, 1u);
  for (const Vertices& polygon : polygons)
    for (const index_t corner : polygon.vertices)
      EXPECT_TRUE(corner >= 1000 && corner < 2000 && corner != 1500) << corner;
}

} // namespace
} // namespace pcl::ccaa::test
