// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of search/cloud_points.h.
#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::ccaa::test {
namespace {

TEST(PointArrayOf, ShowsTheCoordinatesOfAnyPointType)
{
  PointCloud<PointXYZINormal> cloud;
  cloud.resize(2);
  cloud[1].getVector3fMap() = Eigen::Vector3f(1, 2, 3);
  const PointArray points = pointArrayOf(cloud);
  ASSERT_EQ(points.size, 2u);
  EXPECT_EQ(Eigen::Vector3f(points[1]), Eigen::Vector3f(1, 2, 3));
}

TEST(PointArrayOf, IsEmptyForAnEmptyCloud)
{
  EXPECT_EQ(pointArrayOf(PointCloud<PointXYZ>()).size, 0u);
}

TEST(FindIndexOutside, FindsTheFirstIndexThatIsNoPoint)
{
  const Indices indices{0, 4, 5, -1};
  EXPECT_EQ(findIndexOutside(indices, 5) - indices.begin(), 2);
  EXPECT_EQ(findIndexOutside(indices, 6) - indices.begin(), 3);
}

TEST(FindIndexOutside, IsTheEndWhenAllArePoints)
{
  const Indices indices{3, 0, 2}, none;
  EXPECT_EQ(findIndexOutside(indices, 4), indices.end());
  EXPECT_EQ(findIndexOutside(none, 0), none.end());
}

} // namespace
} // namespace pcl::ccaa::test
