// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the offset that brings map coordinates to where floats do.
#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include "mesh/cloud_access.h"
#include "support/clouds.h"

#include <cstring>

namespace pcl::ccaa::test {
namespace {

const Position ORIGIN = Position::Zero();

Positions
mapCloud()
{
  return shifted(onGrid(scaled(bumpySphere(500), 20.0)), MAP_PLACE);
}

TEST(GlobalShift, IsNoneWhereFloatsDo)
{
  EXPECT_TRUE(GlobalShift::of(toRawCloud(bumpySphere(500))).isNone());
  EXPECT_TRUE(GlobalShift::of(toDoubleCloud(bumpySphere(500))).isNone());
}

TEST(GlobalShift, IsTheMiddleOfMapCoordinatesInRoundNumbers)
{
  EXPECT_EQ(Position(596650, 5420320, 250),
            GlobalShift::of(toDoubleCloud(mapCloud())).offset());
}

TEST(GlobalShift, IsAMultipleOfAPowerOfTwoForASmallModel)
{
  const Positions points = shifted(scaled(bumpySphere(500), 0.01), MAP_PLACE);
  const Position offset = GlobalShift::of(toDoubleCloud(points)).offset();
  EXPECT_LT((offset - MAP_PLACE).norm(), 0.02);
  EXPECT_EQ((offset * 1024.0).array().round().matrix(), offset * 1024.0);
}

TEST(GlobalShift, IsTheSameForFloatsOfTheSameCloud)
{
  EXPECT_EQ(GlobalShift::of(toDoubleCloud(mapCloud())).offset(),
            GlobalShift::of(toRawCloud(mapCloud())).offset());
}

TEST(GlobalShift, DoesNotFollowStrayPoints)
{
  Positions points = mapCloud();
  points[0] = points[1] = points[2] = ORIGIN;
  EXPECT_EQ(GlobalShift::of(toDoubleCloud(mapCloud())).offset(),
            GlobalShift::of(toDoubleCloud(points)).offset());
}

TEST(GlobalShift, LooksPastPointsThatAreNotFinite)
{
  EXPECT_EQ(GlobalShift::of(toDoubleCloud(mapCloud())).offset(),
            GlobalShift::of(toDoubleCloud(withNonFinite(mapCloud(), 9))).offset());
}

TEST(GlobalShift, IsNoneForACloudThatCannotBeRead)
{
  EXPECT_TRUE(GlobalShift::of(pcl::PCLPointCloud2()).isNone());
}

TEST(GlobalShift, KeepsAllDigitsInTheLocalFloats)
{
  const Positions points = mapCloud();
  const auto shift = GlobalShift::of(toDoubleCloud(points));
  pcl::PCLPointCloud2 local;
  ASSERT_TRUE(shift.toLocal(toDoubleCloud(points), local));
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(local, cloud);
  ASSERT_EQ(points.size(), cloud.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i], cloud[i].getVector3fMap().cast<double>() + shift.offset());
}

TEST(GlobalShift, MovesSensorPositionsAndNothingElse)
{
  pcl::PointCloud<pcl::PointWithViewpoint> points;
  points.push_back({1, 2, 3, 4, 5, 6});
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  pcl::PCLPointField height = cloud.fields.front();
  height.name = "height";
  cloud.fields.push_back(height);
  pcl::PCLPointCloud2 local;
  ASSERT_TRUE(GlobalShift({1, 1, 1}).toLocal(cloud, local));
  EXPECT_EQ(Position(0, 1, 2), positionView(local)[0]);
  EXPECT_EQ(Position(3, 4, 5), viewpointView(local)[0]);
  float kept = 0;
  std::memcpy(&kept, local.data.data() + local.fields.back().offset, sizeof(kept));
  EXPECT_EQ(1.0F, kept);
}

TEST(GlobalShift, LeadsBackToDoubles)
{
  const Positions points = mapCloud();
  const auto shift = GlobalShift::of(toDoubleCloud(points));
  pcl::PCLPointCloud2 cloud;
  ASSERT_TRUE(shift.toLocal(toDoubleCloud(points), cloud));
  ASSERT_TRUE(shift.toGlobal(pcl::PCLPointCloud2(cloud), cloud));
  EXPECT_EQ(points, copyPositions(positionView(cloud)).positions);
}

TEST(GlobalShift, PutsAMeshBackOnItsCloud)
{
  const pcl::PCLPointCloud2 cloud = toDoubleCloud(mapCloud());
  const auto shift = GlobalShift::of(cloud);
  pcl::PolygonMesh mesh;
  ASSERT_TRUE(shift.toLocal(cloud, mesh.cloud));
  ASSERT_TRUE(shift.restore(cloud, mesh));
  EXPECT_EQ(cloud.data, mesh.cloud.data);
  EXPECT_EQ(cloud.point_step, mesh.cloud.point_step);
}

TEST(GlobalShift, PutsAppendedPointsAtTheirPlace)
{
  const pcl::PCLPointCloud2 cloud = toDoubleCloud(mapCloud());
  const auto shift = GlobalShift::of(cloud);
  pcl::PolygonMesh mesh;
  ASSERT_TRUE(shift.toLocal(cloud, mesh.cloud));
  ASSERT_EQ(CloudProblem::NONE, appendVertices(mesh.cloud, {{{0.5, -2.0, 1.0}, {}}}));
  ASSERT_TRUE(shift.restore(cloud, mesh));
  const PointView view = positionView(mesh.cloud);
  ASSERT_EQ(501U, view.size());
  EXPECT_EQ(Position(shift.offset() + Position(0.5, -2.0, 1.0)), view[500]);
}

TEST(GlobalShift, RefusesAMeshOfAnotherCloud)
{
  pcl::PolygonMesh mesh;
  mesh.cloud = toRawCloud(lineCloud(3));
  EXPECT_FALSE(GlobalShift().restore(toRawCloud(lineCloud(4)), mesh));
  EXPECT_EQ(3U, mesh.cloud.width);
}

TEST(GlobalShift, RefusesACloudWithoutPositions)
{
  pcl::PCLPointCloud2 local;
  EXPECT_FALSE(GlobalShift().toLocal(pcl::PCLPointCloud2(), local));
}

} // namespace
} // namespace pcl::ccaa::test
