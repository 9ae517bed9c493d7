// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of reading with mesh/cloud_access.h.
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include "mesh/cloud_access.h"
#include "support/clouds.h"
#include "support/raw_clouds.h"
#include "support/shared_data.h"

namespace pcl::ccaa::test {
namespace {

TEST(CloudAccess, ReadsPositionsOfFloats)
{
  const Positions points = fibonacciSphere(50);
  const pcl::PCLPointCloud2 cloud = toRawCloud(points);
  ASSERT_EQ(checkCloud(cloud), CloudProblem::NONE);
  const PointView view = positionView(cloud);
  ASSERT_EQ(view.size(), 50u);
  for (std::size_t i = 0; i < 50; ++i)
    EXPECT_EQ(view[i], points[i].cast<float>().cast<double>());
}

TEST(CloudAccess, ReadsPositionsOfDoublesInAnyOrder)
{
  pcl::PCLPointCloud2 cloud = rawCloud({{"z", pcl::PCLPointField::FLOAT64},
                                        {"label", pcl::PCLPointField::UINT16},
                                        {"x", pcl::PCLPointField::FLOAT64},
                                        {"y", pcl::PCLPointField::FLOAT64}},
                                       3);
  setValue<double>(cloud, 2, "x", 0.1);
  setValue<double>(cloud, 2, "y", 0.2);
  setValue<double>(cloud, 2, "z", 0.3);
  ASSERT_EQ(checkCloud(cloud), CloudProblem::NONE);
  EXPECT_EQ(positionView(cloud)[std::size_t{2}], Position(0.1, 0.2, 0.3));
}

TEST(CloudAccess, ReadsOrganisedCloudsWithPaddedRows)
{
  pcl::PCLPointCloud2 cloud = rawCloud(xyzFields(), 6);
  padRows(cloud, 3, 2, 20);
  setPosition(cloud, 20 + 4 * 12, {7.0, 8.0, 9.0});
  ASSERT_EQ(checkCloud(cloud), CloudProblem::NONE);
  EXPECT_EQ(positionView(cloud)[std::size_t{4}], Position(7.0, 8.0, 9.0));
}

TEST(CloudAccess, KeepsPointsThatAreNotFiniteAsNaNAndCountsThem)
{
  const pcl::PCLPointCloud2 cloud = toRawCloud(withNonFinite(fibonacciSphere(40), 6));
  const PositionList list = copyPositions(positionView(cloud));
  EXPECT_EQ(list.non_finite, 6u);
  std::size_t gone = 0;
  for (const Position& position : list.positions)
    gone += position.array().isNaN().all() ? 1u : 0u;
  EXPECT_EQ(gone, 6u);
}

TEST(CloudAccess, NormalsAndViewpointsAreOptional)
{
  const pcl::PCLPointCloud2 plain = toRawCloud(fibonacciSphere(5));
  EXPECT_TRUE(normalView(plain).empty());
  EXPECT_TRUE(viewpointView(plain).empty());
  pcl::PointCloud<pcl::PointNormal> points(2, 1);
  points[1].normal_y = 0.5f;
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  EXPECT_EQ(normalView(cloud)[std::size_t{1}], Position(0.0, 0.5, 0.0));
}

TEST(CloudAccess, ReadsTheViewpointOfEachPoint)
{
  pcl::PointCloud<pcl::PointWithViewpoint> points(2, 1);
  points[1].vp_z = 3.0f;
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  EXPECT_EQ(viewpointView(cloud)[std::size_t{1}], Position(0.0, 0.0, 3.0));
}

TEST(CloudAccess, AcceptsAnEmptyCloud)
{
  const pcl::PCLPointCloud2 cloud = toRawCloud({});
  EXPECT_EQ(checkCloud(cloud), CloudProblem::NONE);
  EXPECT_TRUE(positionView(cloud).empty());
}

TEST(CloudAccess, RefusesACloudWithoutPositions)
{
  EXPECT_EQ(checkCloud({}), CloudProblem::NO_POSITION);
  EXPECT_EQ(
      checkCloud(rawCloud(
          {{"x", pcl::PCLPointField::FLOAT32}, {"y", pcl::PCLPointField::FLOAT32}}, 3)),
      CloudProblem::NO_POSITION);
}

TEST(CloudAccess, RefusesPositionsOfIntegersOrMixedTypes)
{
  EXPECT_EQ(checkCloud(rawCloud({{"x", pcl::PCLPointField::INT32},
                                 {"y", pcl::PCLPointField::INT32},
                                 {"z", pcl::PCLPointField::INT32}},
                                3)),
            CloudProblem::POSITION_TYPE);
  EXPECT_EQ(checkCloud(rawCloud({{"x", pcl::PCLPointField::FLOAT32},
                                 {"y", pcl::PCLPointField::FLOAT64},
                                 {"z", pcl::PCLPointField::FLOAT32}},
                                3)),
            CloudProblem::POSITION_TYPE);
}

TEST(CloudAccess, RefusesAFieldBeyondThePoint)
{
  pcl::PCLPointCloud2 cloud = rawCloud(xyzFields(), 3);
  cloud.fields[2].offset = 9;
  EXPECT_EQ(checkCloud(cloud), CloudProblem::FIELD_OUTSIDE);
  cloud = rawCloud(xyzFields(), 3);
  cloud.fields[2].count = 2;
  EXPECT_EQ(checkCloud(cloud), CloudProblem::FIELD_OUTSIDE);
}

TEST(CloudAccess, RefusesDataOfTheWrongSize)
{
  pcl::PCLPointCloud2 cloud = rawCloud(xyzFields(), 3);
  cloud.data.pop_back();
  EXPECT_EQ(checkCloud(cloud), CloudProblem::DATA_SIZE);
  cloud = rawCloud(xyzFields(), 3);
  cloud.row_step = 24;
  EXPECT_EQ(checkCloud(cloud), CloudProblem::ROW_TOO_SHORT);
  cloud = rawCloud(xyzFields(), 3);
  cloud.width = 4000000000u;
  EXPECT_EQ(checkCloud(cloud), CloudProblem::TOO_MANY_POINTS);
}

TEST(CloudAccess, RefusesTheOtherByteOrder)
{
  pcl::PCLPointCloud2 cloud = rawCloud(xyzFields(), 3);
  cloud.is_bigendian = cloud.is_bigendian == 0;
  EXPECT_EQ(checkCloud(cloud), CloudProblem::FOREIGN_BYTE_ORDER);
}

TEST(CloudAccess, EveryProblemHasASentence)
{
  for (int i = 0; i <= static_cast<int>(CloudProblem::BAD_SOURCE); ++i)
    EXPECT_STRNE(describe(static_cast<CloudProblem>(i)), "unknown problem");
}

TEST(CloudAccess, AcceptsWhatPclReadsFromFiles)
{
  const std::string path = sharedData("rs1_scene/rs1_normals.ply");
  SKIP_WITHOUT_DATA(path);
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::io::loadPLYFile(path, cloud), 0);
  ASSERT_EQ(checkCloud(cloud), CloudProblem::NONE) << describe(checkCloud(cloud));
  EXPECT_EQ(positionView(cloud).size(), 114373u);
  EXPECT_EQ(normalView(cloud).size(), 114373u);
}

} // namespace
} // namespace pcl::ccaa::test
