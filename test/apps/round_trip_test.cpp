// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is written reads back the same, in every format.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "model_samples.h"

#include <cstring>
#include <limits>

namespace app_test {
namespace {

const std::vector<std::string> all_fields = {
    "x", "y", "z", "rgb", "normal_x", "normal_y", "normal_z", "intensity", "label"};

class MeshRoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(MeshRoundTrip, KeepsPointsPolygonsAndFields)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("mesh" + GetParam());
  const pcl::PolygonMesh mesh = colouredSphere();
  save(path, mesh);
  const app::Model model = loadMesh(path);
  expectSamePolygons(mesh, model.mesh);
  const bool has_few = GetParam() == ".obj" || GetParam() == ".off";
  const std::size_t kept = has_few ? 7 : all_fields.size();
  for (std::size_t i = 0; i < kept; ++i)
    expectSameField(mesh.cloud, model.mesh.cloud, all_fields[i]);
  EXPECT_TRUE(model.warnings.empty());
}

TEST_P(MeshRoundTrip, KeepsPointsWithoutTriangles)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("mesh" + GetParam());
  pcl::PolygonMesh mesh = colouredSphere();
  mesh.polygons.clear();
  save(path, mesh);
  const app::Model model = loadMesh(path);
  EXPECT_TRUE(model.mesh.polygons.empty());
  expectSameField(mesh.cloud, model.mesh.cloud, "z");
}

TEST_P(MeshRoundTrip, KeepsNonFinitePoints)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("mesh" + GetParam());
  pcl::PolygonMesh mesh = colouredSphere();
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()};
  std::memcpy(mesh.cloud.data.data() + 5 * mesh.cloud.point_step, values, 12);
  save(path, mesh);
  const app::Model model = loadMesh(path);
  for (const char* axis : {"x", "y", "z"})
    expectSameField(mesh.cloud, model.mesh.cloud, axis);
  EXPECT_FALSE(model.mesh.cloud.is_dense);
}

TEST_P(MeshRoundTrip, KeepsPolygonsOfManyCorners)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("mesh" + GetParam());
  pcl::PolygonMesh mesh;
  mesh.cloud = colouredCloud(400);
  for (const std::size_t corners : {3U, 4U, 5U, 300U}) {
    mesh.polygons.emplace_back();
    for (std::size_t i = 0; i < corners; ++i)
      mesh.polygons.back().vertices.push_back(static_cast<pcl::index_t>(i));
  }
  save(path, mesh);
  expectSamePolygons(mesh, loadMesh(path).mesh);
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         MeshRoundTrip,
                         testing::Values(".ply", ".vtk", ".obj", ".off"),
                         [](const auto& test) { return test.param.substr(1); });

class CloudRoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(CloudRoundTrip, KeepsAllFields)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("cloud" + GetParam());
  const pcl::PCLPointCloud2 cloud = colouredCloud(500);
  save(path, cloud);
  const app::Model model = loadCloud(path);
  for (const std::string& field : all_fields)
    expectSameField(cloud, model.mesh.cloud, field);
}

TEST_P(CloudRoundTrip, KeepsNonFinitePoints)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("cloud" + GetParam());
  pcl::PCLPointCloud2 cloud = colouredCloud(50);
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          1e-42F};
  std::memcpy(cloud.data.data() + 5 * cloud.point_step, values, 12);
  save(path, cloud);
  const app::Model model = loadCloud(path);
  for (const char* axis : {"x", "y", "z"})
    expectSameField(cloud, model.mesh.cloud, axis);
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         CloudRoundTrip,
                         testing::Values(".pcd", ".ply", ".xyz"),
                         [](const auto& test) { return test.param.substr(1); });

TEST(StlRoundTrip, KeepsTrianglesInOrder)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  save(folder.path("mesh.stl"), mesh);
  const app::Model model = loadMesh(folder.path("mesh.stl"));
  ASSERT_EQ(mesh.polygons.size(), model.mesh.polygons.size());
  ASSERT_EQ(app::pointCount(mesh.cloud), app::pointCount(model.mesh.cloud));
  const auto expected = app::readPositions(mesh.cloud);
  const auto actual = app::readPositions(model.mesh.cloud);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto first = static_cast<std::size_t>(mesh.polygons[i].vertices[c]);
      const auto second = static_cast<std::size_t>(model.mesh.polygons[i].vertices[c]);
      ASSERT_EQ(expected[first], actual[second]);
    }
}

TEST(PlyRoundTrip, KeepsFieldsOfSeveralNumbersAsSingleColumns)
{
  const TemporaryFolder folder;
  writeFile(folder.path("a.pcd"),
            "FIELDS x y z histogram\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 3\n"
            "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3 4 5 6\n");
  save(folder.path("a.ply"), loadCloud(folder.path("a.pcd")).mesh.cloud);
  const app::Model model = loadCloud(folder.path("a.ply"));
  EXPECT_EQ(4, valueOf(model.mesh.cloud, 0, "histogram_0"));
  EXPECT_EQ(6, valueOf(model.mesh.cloud, 0, "histogram_2"));
}

TEST(PlyWriter, WritesLabelsOfFaces)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  app::FaceProperty origin{"origin", {}};
  origin.values.assign(mesh.polygons.size(), 3);
  app::OutputFile file;
  app::Warnings warnings;
  ASSERT_TRUE(file.open(folder.path("a.ply")).ok());
  app::writeMesh("a.ply", mesh, {{origin}, {}, {}}, file, warnings);
  ASSERT_TRUE(file.commit().ok());
  EXPECT_NE(std::string::npos,
            readFile(folder.path("a.ply")).find("property int origin\n"));
  const app::Model model = loadMesh(folder.path("a.ply"));
  expectSamePolygons(mesh, model.mesh);
  ASSERT_EQ(1U, model.warnings.size()); // labels are not read back, and it says so
}

} // namespace
} // namespace app_test
