// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the umbrella filter as a class in PCL pipelines.
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include "filter_helpers.h"
#include "support/clouds.h"

#include <chrono>
#include <limits>

namespace pcl::ccaa::test {
namespace {

/** \brief Errors are part of these tests: keep them off the terminal. */
class QuietPcl {
public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel())
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

pcl::PolygonMesh::Ptr
meshOf(const Shape& shape)
{
  return pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape));
}

/** \brief A mesh with colours, an unknown field and a header to be kept. */
pcl::PolygonMesh::Ptr
colouredMesh()
{
  const auto shape = icosphere(2);
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  for (const auto& vertex : shape.vertices) {
    pcl::PointXYZRGBNormal point;
    point.getVector3fMap() = vertex.cast<float>();
    point.getNormalVector3fMap() = vertex.cast<float>().normalized();
    point.r = static_cast<std::uint8_t>(cloud.size());
    point.g = 77;
    cloud.push_back(point);
  }
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(cloud, mesh->cloud);
  mesh->polygons = toPolygons(shape.triangles);
  mesh->header.frame_id = "sensor";
  mesh->header.seq = 12;
  mesh->header.stamp = 345;
  mesh->cloud.header.frame_id = "cloud";
  return mesh;
}

TEST(UmbrellaFilter, KeepsCloudFieldsAndHeader)
{
  const auto input = colouredMesh();
  const pcl::PolygonMesh before = *input;
  UmbrellaFilter filter;
  filter.setInputMesh(input);
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_TRUE(sameCloud(before.cloud, output.cloud));
  EXPECT_TRUE(sameCloud(before.cloud, input->cloud));
  EXPECT_EQ(output.header.frame_id, "sensor");
  EXPECT_EQ(output.header.seq, 12u);
  EXPECT_EQ(output.header.stamp, 345u);
  EXPECT_EQ(output.cloud.header.frame_id, "cloud");
  EXPECT_EQ(toTriangles(input->polygons), toTriangles(before.polygons));
}

TEST(UmbrellaFilter, KeepsInputOrderAndWindings)
{
  const auto shape = damaged(grid(12, 12), 0.1, 3);
  UmbrellaFilter filter;
  filter.setConsistentOrientation(false);
  const auto result = filterWith(filter, shape);
  auto place = shape.triangles.begin();
  for (const auto& triangle : result.triangles) {
    place = std::find(place, shape.triangles.end(), triangle);
    ASSERT_NE(place, shape.triangles.end());
  }
  EXPECT_EQ(result.report.reversed_triangles, 0u);
}

TEST(UmbrellaFilter, WindsRegionsOutward)
{
  auto shape = icosphere(2);
  const auto outward = shape.triangles;
  shape.triangles = randomlyReversed(shape.triangles, 3);
  const auto result = filtered(shape, 10);
  EXPECT_TRUE(sameTriangles(outward, result.triangles));
  EXPECT_GT(result.report.reversed_triangles, 0u);
}

TEST(UmbrellaFilter, WindsByTheNormalsOfTheCloud)
{
  auto inward = colouredMesh();
  pcl::PointCloud<pcl::PointNormal> cloud;
  pcl::fromPCLPointCloud2(inward->cloud, cloud);
  for (auto& point : cloud)
    point.getNormalVector3fMap() *= -1.0f;
  pcl::toPCLPointCloud2(cloud, inward->cloud);
  UmbrellaFilter filter;
  filter.setInputMesh(inward);
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_EQ(filter.getReport().reversed_triangles, inward->polygons.size());
}

TEST(UmbrellaFilter, ReportsOneSidedRegions)
{
  const auto shape = moebiusBand(40);
  const auto result = filtered(shape, 0);
  expectCertified(shape, result);
  EXPECT_EQ(result.report.one_sided_components, 1u);
  EXPECT_EQ(result.triangles, shape.triangles);
}

TEST(UmbrellaFilter, AcceptsItsInputAsOutput)
{
  const auto shape = damaged(icosphere(3), 0.05, 8);
  const auto expected = filtered(shape, 10);
  const auto mesh = meshOf(shape);
  const auto cloud = mesh->cloud;
  UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  filter.process(*mesh);
  EXPECT_EQ(toTriangles(mesh->polygons), expected.triangles);
  EXPECT_TRUE(sameCloud(cloud, mesh->cloud));
}

TEST(UmbrellaFilter, CanBeUsedAgain)
{
  UmbrellaFilter filter;
  const auto large = damaged(icosphere(3), 0.05, 8);
  const auto small = icosphere(1);
  const auto first = filterWith(filter, large);
  EXPECT_EQ(filterWith(filter, small).triangles, filtered(small, 10).triangles);
  const auto again = filterWith(filter, large);
  EXPECT_EQ(first.triangles, again.triangles);
  EXPECT_EQ(first.roles, again.roles);
  EXPECT_EQ(first.report.umbrella_triangles, again.report.umbrella_triangles);
}

TEST(UmbrellaFilter, AcceptsEmptyMeshes)
{
  UmbrellaFilter filter;
  filter.setInputMesh(pcl::make_shared<pcl::PolygonMesh>());
  pcl::PolygonMesh output = *meshOf(tetrahedron());
  filter.process(output);
  EXPECT_TRUE(output.polygons.empty());
  EXPECT_EQ(output.cloud.width * output.cloud.height, 0u);
  EXPECT_TRUE(filter.getPointRoles().empty());

  const auto points_only = filterWith(filter, Shape{icosphere(1).vertices, {}});
  EXPECT_EQ(points_only.report.free_points, 42u);
  EXPECT_EQ(points_only.roles, std::vector<PointRole>(42, PointRole::FREE));
}

TEST(UmbrellaFilter, LeavesOutInvalidPolygons)
{
  const QuietPcl quiet;
  auto mesh = meshOf(icosphere(2));
  const std::vector<std::vector<pcl::index_t>> wrong{
      {}, {1}, {1, 2}, {1, 1, 2}, {-1, 2, 3}, {0, 1, 1000000}, {0, 1, 2, 0}};
  for (const auto& corners : wrong) {
    pcl::Vertices polygon;
    polygon.vertices.assign(corners.begin(), corners.end());
    mesh->polygons.push_back(polygon);
  }
  UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_EQ(filter.getReport().input_polygons, mesh->polygons.size());
  EXPECT_EQ(filter.getReport().invalid_polygons, wrong.size());
  EXPECT_TRUE(
      sameUnorientedTriangles(icosphere(2).triangles, toTriangles(output.polygons)));
}

TEST(UmbrellaFilter, LeavesOutPolygonsWithPointsThatAreNotFinite)
{
  const QuietPcl quiet;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    auto shape = icosphere(2);
    shape.vertices[20].z() = bad;
    const auto result = filtered(shape, 10);
    EXPECT_EQ(result.report.invalid_polygons, 6u);
    EXPECT_EQ(result.roles[20], PointRole::FREE);
    EXPECT_TRUE(isIcadm(result.triangles, shape.vertices.size()));
  }
}

TEST(UmbrellaFilter, CutsLargePolygonsIntoFans)
{
  const auto shape = cube(1);
  auto mesh = meshOf(shape);
  mesh->polygons.clear();
  for (const auto& corners : {std::array<pcl::index_t, 4>{0, 1, 2, 3},
                              std::array<pcl::index_t, 4>{3, 2, 4, 5}}) {
    pcl::Vertices polygon;
    polygon.vertices.assign(corners.begin(), corners.end());
    mesh->polygons.push_back(polygon);
  }
  UmbrellaFilter filter;
  filter.setMinimumInternalPoints(0);
  filter.setInputMesh(mesh);
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_EQ(output.polygons.size(), 4u);
  EXPECT_EQ(filter.getReport().input_polygons, 2u);
  EXPECT_EQ(filter.getReport().components, 1u);
}

TEST(UmbrellaFilter, RefusesCloudsItCannotRead)
{
  const QuietPcl quiet;
  for (int kind = 0; kind < 3; ++kind) {
    auto mesh = meshOf(icosphere(1));
    if (kind == 0)
      mesh->cloud.fields[1].name = "height";
    else if (kind == 1)
      mesh->cloud.data.resize(mesh->cloud.data.size() / 2);
    else
      mesh->cloud.fields[0].datatype = pcl::PCLPointField::INT32;
    UmbrellaFilter filter;
    filter.setInputMesh(mesh);
    pcl::PolygonMesh output = *meshOf(tetrahedron());
    filter.process(output);
    EXPECT_TRUE(output.polygons.empty());
    EXPECT_TRUE(filter.getPointRoles().empty());
    EXPECT_EQ(filter.getReport().input_polygons, 0u);
  }
}

TEST(UmbrellaFilter, IgnoresScaleAndDistanceFromTheOrigin)
{
  const auto shape = damaged(terrain(20, 20), 0.1, 4);
  const auto expected = filtered(shape, 10);
  for (const double scale : {1e-4, 1e6})
    EXPECT_EQ(filtered(scaled(shape, scale), 10).triangles.size(),
              expected.triangles.size());
}

TEST(UmbrellaFilter, LeavesAnEmptyResultWhenCancelledAtAnyTime)
{
  const auto mesh = meshOf(damaged(torus(120, 100), 0.05, 2));
  std::size_t calls = 0;
  UmbrellaFilter filter;
  filter.setNumberOfThreads(1);
  filter.setInputMesh(mesh);
  filter.setProgressCallback([&](const std::string& stage, double fraction) {
    EXPECT_FALSE(stage.empty());
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    ++calls;
    return true;
  });
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_FALSE(output.polygons.empty());
  EXPECT_FALSE(filter.getReport().cancelled);
  const std::size_t all_calls = calls;
  for (std::size_t last = 1; last <= all_calls; ++last) {
    calls = 0;
    filter.setProgressCallback(
        [&](const std::string&, double) { return ++calls < last; });
    filter.process(output);
    EXPECT_EQ(calls, last) << "asked again after it has said no";
    EXPECT_TRUE(output.polygons.empty());
    EXPECT_TRUE(filter.getPointRoles().empty());
    EXPECT_TRUE(filter.getReport().cancelled);
  }
  filter.setProgressCallback({});
  filter.process(output);
  EXPECT_FALSE(output.polygons.empty());
}

TEST(UmbrellaFilter, AsksForCancellingOften)
{
  using Clock = std::chrono::steady_clock;
  const auto mesh = meshOf(shuffled(torus(600, 500), 2));
  UmbrellaFilter filter;
  filter.setNumberOfThreads(1);
  filter.setInputMesh(mesh);
  auto last = Clock::now();
  std::vector<double> pauses;
  filter.setProgressCallback([&](const std::string&, double) {
    const auto now = Clock::now();
    pauses.push_back(std::chrono::duration<double>(now - last).count());
    last = now;
    return true;
  });
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_GT(pauses.size(), 100u);
}

} // namespace
} // namespace pcl::ccaa::test
