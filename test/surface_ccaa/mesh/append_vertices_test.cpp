// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of appendVertices() in mesh/cloud_access.h.
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include "mesh/cloud_access.h"
#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "support/raw_clouds.h"

#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

NewVertex
between(index_t a, double weight_a, index_t b, double weight_b)
{
  NewVertex vertex;
  vertex.position = {1.0, 2.0, 3.0};
  vertex.sources = {{a, weight_a}, {b, weight_b}};
  return vertex;
}

/** \brief A cloud of three points with one more field. */
pcl::PCLPointCloud2
cloudWith(const std::string& name, std::uint8_t type)
{
  FieldList fields = xyzFields();
  fields.emplace_back(name, type);
  return rawCloud(fields, 3);
}

TEST(AppendVertices, ExistingPointsKeepTheirBytes)
{
  const pcl::PCLPointCloud2 before = toRawCloud(withNonFinite(bumpySphere(30), 4));
  pcl::PCLPointCloud2 cloud = before;
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1), NewVertex()}),
            CloudProblem::NONE);
  EXPECT_EQ(cloud.width, 32u);
  EXPECT_EQ(checkCloud(cloud), CloudProblem::NONE);
  EXPECT_TRUE(std::equal(before.data.begin(), before.data.end(), cloud.data.begin()));
  EXPECT_EQ(cloud.is_dense, before.is_dense);
}

TEST(AppendVertices, TakesThePositionGiven)
{
  pcl::PCLPointCloud2 cloud = toRawCloud(fibonacciSphere(4));
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1)}), CloudProblem::NONE);
  EXPECT_EQ(positionView(cloud)[std::size_t{4}], Position(1.0, 2.0, 3.0));
}

TEST(AppendVertices, WritesPositionsOfDoublesInFull)
{
  pcl::PCLPointCloud2 cloud = rawCloud({{"x", pcl::PCLPointField::FLOAT64},
                                        {"y", pcl::PCLPointField::FLOAT64},
                                        {"z", pcl::PCLPointField::FLOAT64}},
                                       1);
  NewVertex vertex;
  vertex.position = {0.1, 0.2, 0.3};
  ASSERT_EQ(appendVertices(cloud, {vertex}), CloudProblem::NONE);
  EXPECT_EQ(positionView(cloud)[std::size_t{1}], vertex.position);
}

TEST(AppendVertices, InterpolatesFloats)
{
  pcl::PCLPointCloud2 cloud = cloudWith("intensity", pcl::PCLPointField::FLOAT32);
  setValue<float>(cloud, 0, "intensity", 10.0f);
  setValue<float>(cloud, 1, "intensity", 20.0f);
  ASSERT_EQ(appendVertices(cloud, {between(0, 3, 1, 1)}), CloudProblem::NONE);
  EXPECT_FLOAT_EQ(valueOf<float>(cloud, 3, "intensity"), 12.5f);
}

TEST(AppendVertices, LeavesOutValuesThatAreNotFinite)
{
  pcl::PCLPointCloud2 cloud = cloudWith("intensity", pcl::PCLPointField::FLOAT64);
  setValue(cloud, 0, "intensity", std::numeric_limits<double>::quiet_NaN());
  setValue(cloud, 1, "intensity", 20.0);
  ASSERT_EQ(appendVertices(cloud, {between(0, 3, 1, 1), between(0, 1, 0, 1)}),
            CloudProblem::NONE);
  EXPECT_EQ(valueOf<double>(cloud, 3, "intensity"), 20.0);
  EXPECT_TRUE(std::isnan(valueOf<double>(cloud, 4, "intensity")));
}

TEST(AppendVertices, InterpolatesEachValueOfAFieldOfSeveral)
{
  pcl::PCLPointCloud2 cloud = rawCloud({{"x", pcl::PCLPointField::FLOAT32},
                                        {"y", pcl::PCLPointField::FLOAT32},
                                        {"z", pcl::PCLPointField::FLOAT32},
                                        {"histogram", pcl::PCLPointField::FLOAT32},
                                        {"_", pcl::PCLPointField::FLOAT32}},
                                       2);
  cloud.fields.pop_back();
  cloud.fields.back().count = 2;
  const float second[2] = {4.0f, 8.0f};
  std::memcpy(cloud.data.data() + 20 + 12, second, sizeof(second));
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1)}), CloudProblem::NONE);
  float mixed[2];
  std::memcpy(mixed, cloud.data.data() + 40 + 12, sizeof(mixed));
  EXPECT_FLOAT_EQ(mixed[0], 2.0f);
  EXPECT_FLOAT_EQ(mixed[1], 4.0f);
}

TEST(AppendVertices, MixesPackedColoursChannelByChannel)
{
  for (const std::uint8_t type :
       {pcl::PCLPointField::FLOAT32, pcl::PCLPointField::UINT32}) {
    pcl::PCLPointCloud2 cloud =
        cloudWith(type == pcl::PCLPointField::UINT32 ? "rgba" : "rgb", type);
    const std::string name = cloud.fields.back().name;
    setValue<std::uint32_t>(cloud, 0, name, 0xff0040ffu);
    setValue<std::uint32_t>(cloud, 1, name, 0xff804000u);
    ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1)}), CloudProblem::NONE);
    EXPECT_EQ(valueOf<std::uint32_t>(cloud, 3, name), 0xff404080u);
  }
}

TEST(AppendVertices, TakesIntegersFromTheHeaviestSource)
{
  pcl::PCLPointCloud2 cloud = cloudWith("label", pcl::PCLPointField::UINT16);
  setValue<std::uint16_t>(cloud, 0, "label", 7);
  setValue<std::uint16_t>(cloud, 1, "label", 9);
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 2), between(0, 1, 1, 1)}),
            CloudProblem::NONE);
  EXPECT_EQ(valueOf<std::uint16_t>(cloud, 3, "label"), 9);
  EXPECT_EQ(valueOf<std::uint16_t>(cloud, 4, "label"), 7);
}

pcl::PCLPointCloud2
cloudWithNormals(const Eigen::Vector3f& first, const Eigen::Vector3f& second)
{
  pcl::PointCloud<pcl::PointNormal> points(2, 1);
  points[0].getNormalVector3fMap() = first;
  points[1].getNormalVector3fMap() = second;
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  return cloud;
}

TEST(AppendVertices, NormalsAreOfUnitLength)
{
  pcl::PCLPointCloud2 cloud = cloudWithNormals({2, 0, 0}, {0, 2, 0});
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1)}), CloudProblem::NONE);
  const Position normal = normalView(cloud)[std::size_t{2}];
  EXPECT_NEAR(
      (normal - Position(std::sqrt(0.5), std::sqrt(0.5), 0.0)).norm(), 0.0, 1e-6);
}

TEST(AppendVertices, OppositeNormalsGiveThatOfTheHeaviestSource)
{
  pcl::PCLPointCloud2 cloud = cloudWithNormals({0, 0, -1}, {0, 0, 1});
  ASSERT_EQ(appendVertices(cloud, {between(0, 1, 1, 1)}), CloudProblem::NONE);
  EXPECT_EQ(normalView(cloud)[std::size_t{2}], Position(0.0, 0.0, -1.0));
}

TEST(AppendVertices, WeightsOfZeroOrLessDoNotCount)
{
  pcl::PCLPointCloud2 cloud = cloudWith("intensity", pcl::PCLPointField::FLOAT32);
  setValue<float>(cloud, 0, "intensity", 10.0f);
  setValue<float>(cloud, 1, "intensity", 20.0f);
  ASSERT_EQ(appendVertices(cloud, {between(0, 0, 1, 0.5), between(0, 1, 1, -3)}),
            CloudProblem::NONE);
  EXPECT_EQ(valueOf<float>(cloud, 3, "intensity"), 20.0f);
  EXPECT_EQ(valueOf<float>(cloud, 4, "intensity"), 10.0f);
}

TEST(AppendVertices, WithoutSourcesOtherFieldsAreZero)
{
  pcl::PCLPointCloud2 cloud = cloudWith("label", pcl::PCLPointField::INT32);
  setValue<std::int32_t>(cloud, 0, "label", 5);
  ASSERT_EQ(appendVertices(cloud, {NewVertex()}), CloudProblem::NONE);
  EXPECT_EQ(valueOf<std::int32_t>(cloud, 3, "label"), 0);
}

TEST(AppendVertices, OrganisedCloudsBecomeUnorganised)
{
  const pcl::PCLPointCloud2 flat = toRawCloud(fibonacciSphere(6));
  pcl::PCLPointCloud2 cloud = flat;
  padRows(cloud, 3, 2, 10);
  ASSERT_EQ(appendVertices(cloud, {between(4, 1, 5, 1)}), CloudProblem::NONE);
  EXPECT_EQ(cloud.width, 7u);
  EXPECT_EQ(cloud.height, 1u);
  EXPECT_EQ(cloud.row_step, 7 * cloud.point_step);
  EXPECT_TRUE(std::equal(flat.data.begin(), flat.data.end(), cloud.data.begin()));
}

TEST(AppendVertices, NothingToAppendLeavesAnOrganisedCloudAsItIs)
{
  pcl::PCLPointCloud2 cloud = toRawCloud(fibonacciSphere(6));
  padRows(cloud, 3, 2, 10);
  const pcl::PCLPointCloud2 before = cloud;
  ASSERT_EQ(appendVertices(cloud, {}), CloudProblem::NONE);
  EXPECT_TRUE(sameCloud(before, cloud));
}

TEST(AppendVertices, APositionThatIsNotFiniteClearsIsDense)
{
  pcl::PCLPointCloud2 cloud = toRawCloud(fibonacciSphere(3));
  NewVertex vertex;
  vertex.position.x() = std::numeric_limits<double>::infinity();
  ASSERT_EQ(appendVertices(cloud, {vertex}), CloudProblem::NONE);
  EXPECT_EQ(cloud.is_dense, 0);
}

TEST(AppendVertices, WorksOnAnEmptyCloud)
{
  pcl::PCLPointCloud2 cloud = toRawCloud({});
  ASSERT_EQ(appendVertices(cloud, {NewVertex()}), CloudProblem::NONE);
  EXPECT_EQ(positionView(cloud).size(), 1u);
}

TEST(AppendVertices, RefusesASourceThatIsNotInTheCloud)
{
  const pcl::PCLPointCloud2 before = toRawCloud(fibonacciSphere(3));
  pcl::PCLPointCloud2 cloud = before;
  EXPECT_EQ(appendVertices(cloud, {NewVertex(), between(0, 1, 3, 1)}),
            CloudProblem::BAD_SOURCE);
  EXPECT_EQ(appendVertices(cloud, {between(-1, 1, 0, 1)}), CloudProblem::BAD_SOURCE);
  EXPECT_TRUE(sameCloud(before, cloud));
}

TEST(AppendVertices, RefusesAMalformedCloud)
{
  pcl::PCLPointCloud2 cloud = toRawCloud(fibonacciSphere(3));
  cloud.data.pop_back();
  EXPECT_EQ(appendVertices(cloud, {NewVertex()}), CloudProblem::DATA_SIZE);
}

} // namespace
} // namespace pcl::ccaa::test
