// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_ccaa_reconstruct as a user runs it.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "model_samples.h"
#include "reconstruct_fixture.h"
#include "support/mesh_asserts.h"
#include "support/shared_data.h"

#include <cstring>
#include <limits>

namespace app_test {
namespace {

TEST_F(ReconstructApp, MeshesACloudAndKeepsItsFieldsBitForBit)
{
  const pcl::PCLPointCloud2 cloud = colouredCloud(4000);
  save(folder_.path("in.pcd"), cloud);
  const RunResult result = reconstruct("in.pcd", "out.ply");
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(isOneLineWithVerdict(result.output)) << result.output;
  EXPECT_EQ("", result.errors);
  EXPECT_EQ((std::vector<std::string>{"in.pcd", "out.ply"}), folder_.names());
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  for (const pcl::PCLPointField& field : cloud.fields)
    expectSameField(cloud, mesh.cloud, field.name);
  const auto triangles = test::toTriangles(mesh.polygons);
  EXPECT_GT(triangles.size(), 6000U);
  EXPECT_TRUE(test::isIcadm(triangles, 4000));
  EXPECT_TRUE(test::isConsistentlyWound(triangles));
}

TEST_F(ReconstructApp, GivesTheSameFileForAnyNumberOfThreads)
{
  save(folder_.path("in.ply"), colouredCloud(5000, 3));
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "1.ply", {"--threads", "1"})));
  for (const char* threads : {"2", "7", "0"}) {
    ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "n.ply", {"--threads", threads})));
    EXPECT_TRUE(readFile(folder_.path("1.ply")) == readFile(folder_.path("n.ply")));
  }
}

TEST_F(ReconstructApp, BothSearchesGiveSoundMeshes)
{
  save(folder_.path("in.ply"), colouredCloud(3000));
  for (const char* search : {"fast", "kdtree"}) {
    ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply", {"--search", search})));
    const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
    EXPECT_TRUE(test::isIcadm(test::toTriangles(mesh.polygons), 3000));
  }
}

TEST_F(ReconstructApp, WritesEveryMeshFormat)
{
  save(folder_.path("in.xyz"), colouredCloud(2000));
  ASSERT_TRUE(hasMeshed(reconstruct("in.xyz", "out.ply")));
  const auto expected = loadMesh(folder_.path("out.ply")).mesh;
  for (const char* name : {"out.vtk", "out.obj"}) {
    ASSERT_TRUE(hasMeshed(reconstruct("in.xyz", name)));
    expectSamePolygons(expected, loadMesh(folder_.path(name)).mesh);
  }
  const RunResult stl = reconstruct("in.xyz", "out.stl");
  EXPECT_EQ(0, stl.exit_code);
  EXPECT_NE(std::string::npos, stl.errors.find("note: STL"));
  EXPECT_EQ(expected.polygons.size(),
            loadMesh(folder_.path("out.stl")).mesh.polygons.size());
}

TEST_F(ReconstructApp, ReportsTheRun)
{
  save(folder_.path("in.pcd"), colouredCloud(3000));
  const std::vector<std::string> options{"--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.pcd", "out.ply", options)));
  const nlohmann::json json = report();
  EXPECT_EQ(3000, json.at("N"));
  EXPECT_EQ(3000, json.at("usable_points"));
  EXPECT_GT(json.at("k"), 0.9);
  EXPECT_GT(json.at("internal_share"), 0.7);
  EXPECT_EQ(loadMesh(folder_.path("out.ply")).mesh.polygons.size(),
            json.at("triangles"));
  ASSERT_EQ(5U, json.at("stages").size());
  double sum = 0;
  for (const auto& stage : json.at("stages")) {
    EXPECT_GE(stage.at("seconds"), 0.0);
    EXPECT_DOUBLE_EQ(stage.at("seconds").get<double>() * 1e6 / 3000,
                     stage.at("us_per_point").get<double>());
    sum += stage.at("seconds").get<double>();
  }
  EXPECT_NEAR(sum, json.at("total_seconds"), 1e-9);
  EXPECT_GT(json.at("peak_memory_bytes"), 1000000);
  EXPECT_EQ("fast", json.at("search"));
  const auto made = json.at("triangles_by_stage");
  EXPECT_EQ(json.at("umbrella").at("output_triangles"), made.at("start"));
  EXPECT_EQ(json.at("triangles"),
            made.at("start").get<int>() + made.at("base").get<int>());
  for (const char* cost : {"c_B", "c_F", "base_seconds"})
    EXPECT_GE(json.at(cost), 0.0) << cost;
  EXPECT_LE(json.at("free_points"), 30);
  EXPECT_FALSE(json.contains("speedup"));
}

TEST_F(ReconstructApp, KeepsNonFinitePointsInPlace)
{
  pcl::PCLPointCloud2 cloud = colouredCloud(2000);
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
  for (const std::size_t i : {0U, 700U, 1999U})
    std::memcpy(cloud.data.data() + i * cloud.point_step, bad, sizeof(bad));
  save(folder_.path("in.pcd"), cloud);
  const RunResult result = reconstruct("in.pcd", "out.ply");
  EXPECT_EQ(0, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("3 points")) << result.errors;
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  for (const char* axis : {"x", "y", "z"})
    expectSameField(cloud, mesh.cloud, axis);
  for (const auto& triangle : test::toTriangles(mesh.polygons))
    for (const pcl::index_t corner : triangle)
      EXPECT_TRUE(corner != 0 && corner != 700 && corner != 1999);
}

TEST_F(ReconstructApp, KeepsDuplicatesAndCountsThemOnce)
{
  std::string text;
  const auto positions = app::readPositions(colouredCloud(1500));
  for (int copy = 0; copy < 5; ++copy)
    for (const auto& p : positions)
      text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
              std::to_string(p.z()) + "\n";
  writeFile(folder_.path("in.xyz"), text);
  const std::vector<std::string> options{"--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.xyz", "out.ply", options)));
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  EXPECT_EQ(7500U, app::pointCount(mesh.cloud));
  EXPECT_TRUE(test::isIcadm(test::toTriangles(mesh.polygons), 7500));
  EXPECT_EQ(1500, report().at("usable_points"));
  EXPECT_GT(report().at("k_usable"), 0.9);
  EXPECT_LT(report().at("k"), 0.21);
}

TEST_F(ReconstructApp, SaysWhenNoTriangleCanBeMade)
{
  std::string line;
  for (int i = 0; i < 200; ++i)
    line += std::to_string(i) + " " + std::to_string(2 * i) + " 0\n";
  writeFile(folder_.path("in.xyz"), line);
  const RunResult result = reconstruct("in.xyz", "out.ply");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  EXPECT_EQ(200U, app::pointCount(mesh.cloud));
  EXPECT_TRUE(mesh.polygons.empty());
}

TEST_F(ReconstructApp, RefusesManyIdenticalPoints)
{
  std::string text;
  for (int i = 0; i < 100000; ++i)
    text += "1 2 3\n";
  writeFile(folder_.path("in.xyz"), text);
  const RunResult result = reconstruct("in.xyz", "out.ply");
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors));
  EXPECT_EQ(1U, folder_.names().size());
}

TEST_F(ReconstructApp, StopsAfterTheStart)
{
  save(folder_.path("in.ply"), colouredCloud(2000));
  const std::vector<std::string> options{
      "--until", "start", "--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply", options)));
  EXPECT_EQ(3U, report().at("stages").size());
  for (const char* later : {"internal_share",
                            "c_F",
                            "base_seconds",
                            "boundary_loops",
                            "genus",
                            "watertight"})
    EXPECT_TRUE(report().at(later).is_null()) << later;
}

TEST_F(ReconstructApp, StopsAfterTheFilter)
{
  save(folder_.path("in.ply"), colouredCloud(2000));
  const std::vector<std::string> options{
      "--until", "filter", "--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply", options)));
  EXPECT_EQ(4U, report().at("stages").size());
  EXPECT_TRUE(report().at("base_seconds").is_null());
  EXPECT_EQ(report().at("triangles"), report().at("umbrella").at("output_triangles"));
}

TEST_F(ReconstructApp, TheBaseKeepsWhatTheFilterLeft)
{
  save(folder_.path("in.ply"), colouredCloud(3000));
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "base.ply")));
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "part.ply", {"--until", "filter"})));
  const auto part = test::toTriangles(loadMesh(folder_.path("part.ply")).mesh.polygons);
  const auto all = test::toTriangles(loadMesh(folder_.path("base.ply")).mesh.polygons);
  EXPECT_TRUE(test::isSubsetOf(part, all));
}

TEST_F(ReconstructApp, RefusesBadValuesOfOptions)
{
  save(folder_.path("in.ply"), colouredCloud(500));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--until", "end"},
        {"--until", "filter", "--measure-speedup"},
        {"--until", "start", "--normals"},
        {"--search", "slow"},
        {"--threads", "-1"},
        {"--threads", "many"},
        {"--threads", "99999999999999999999"},
        {"--neighbors", "2"},
        {"--neighbors", "65"},
        {"--min-angle", "nan"},
        {"--min-angle", "-1"},
        {"--min-angle", "61"},
        {"--min-region", "-5"},
        {"--report", folder_.path("no/report.json")},
        {"--report", folder_.path("out.ply")},
        {"--report", folder_.path("in.ply")}}) {
    SCOPED_TRACE(options[1]);
    const RunResult result = reconstruct("in.ply", "out.ply", options);
    EXPECT_EQ(1, result.exit_code);
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ(1U, folder_.names().size());
  }
}

TEST_F(ReconstructApp, LeavesNothingBehindWhenInterrupted)
{
  save(folder_.path("in.pcd"), colouredCloud(300000));
  for (const int delay_ms : {5, 60, 150, 250, 400}) {
    const RunResult result =
        runAndInterrupt("pcl_ccaa_reconstruct",
                        {folder_.path("in.pcd"), folder_.path("out.ply")},
                        delay_ms);
    // A fast machine may be through before the signal, a slow one not yet ready for it.
    if (result.exit_code == 0) {
      std::filesystem::remove(folder_.path("out.ply"));
      continue;
    }
    EXPECT_TRUE(result.exit_code == 130 || result.exit_code == -1) << result.exit_code;
    EXPECT_EQ(std::vector<std::string>{"in.pcd"}, folder_.names());
  }
}

TEST_F(ReconstructApp, OverwritesThroughALinkAndKeepsTheLink)
{
  save(folder_.path("in.ply"), colouredCloud(500));
  writeFile(folder_.path("real.ply"), "old");
  std::filesystem::create_symlink(folder_.path("real.ply"), folder_.path("out.ply"));
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.path("out.ply")));
  EXPECT_EQ(500U, app::pointCount(loadMesh(folder_.path("real.ply")).mesh.cloud));
}

TEST_F(ReconstructApp, MeshesTheBunny)
{
  const std::string bunny = test::sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(bunny);
  const RunResult result =
      runApp("pcl_ccaa_reconstruct",
             {bunny, folder_.path("out.ply"), "--report", folder_.path("report.json")});
  EXPECT_TRUE(hasMeshed(result));
  EXPECT_EQ(35947, report().at("N"));
  EXPECT_GT(report().at("k"), 0.99);
  EXPECT_GT(report().at("internal_share"), 0.93);
}

} // namespace
} // namespace app_test
