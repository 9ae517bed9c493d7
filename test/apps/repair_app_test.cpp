// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_repair_holes as a user runs it.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "repair_fixture.h"
#include "support/shared_data.h"

#include <algorithm>
#include <cstdlib>

namespace app_test {
namespace {

const std::vector<std::string> ALL_WITHOUT_PICTURES{"free_points.pcd",
                                                    "islands.vtk",
                                                    "legend.txt",
                                                    "line_normals.vtk",
                                                    "line_points.pcd",
                                                    "lines.vtk",
                                                    "loops.vtk",
                                                    "origins.pcd",
                                                    "section.vtk",
                                                    "slice.vtk"};

bool
contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST_F(RepairApp, WritesWhatItFound)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = inspectQuickly("caps.ply");
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ("", result.errors);
  EXPECT_EQ(ALL_WITHOUT_PICTURES, found());
}

TEST_F(RepairApp, SumsUpForPeople)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = inspectQuickly("caps.ply");
  for (const char* words :
       {"ICM3, 2 islands", "2 island rim", "reached another boundary"})
    EXPECT_TRUE(contains(result.output, words)) << words << "\n" << result.output;
}

TEST_F(RepairApp, WritesFilesThatReadBack)
{
  const pcl::PolygonMesh caps = twoCaps();
  save(folder_.path("caps.ply"), caps);
  ASSERT_EQ(0, inspectQuickly("caps.ply").exit_code);
  EXPECT_EQ(caps.polygons.size(),
            loadMesh(foundFile("islands.vtk")).mesh.polygons.size());
  for (const char* name :
       {"loops.vtk", "lines.vtk", "line_normals.vtk", "slice.vtk", "section.vtk"}) {
    const auto cloud = loadMesh(foundFile(name)).mesh.cloud;
    EXPECT_GT(app::pointCount(cloud), 0U) << name;
    EXPECT_TRUE(app::findField(cloud, "rgb")) << name;
  }
  for (const char* name : {"line_points.pcd", "origins.pcd", "free_points.pcd"})
    EXPECT_GT(app::pointCount(loadCloud(foundFile(name)).mesh.cloud), 0U) << name;
}

TEST_F(RepairApp, BridgesOfACutSphereHaveOutwardNormals)
{
  save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(0, inspectQuickly("caps.ply").exit_code);
  const auto cloud = loadCloud(foundFile("line_points.pcd")).mesh.cloud;
  for (std::size_t i = 0; i < app::pointCount(cloud); ++i) {
    double along = 0.0;
    for (const std::string axis : {"x", "y", "z"})
      along += valueOf(cloud, i, axis) * valueOf(cloud, i, "normal_" + axis);
    EXPECT_GT(along, 0.5) << i;
  }
  EXPECT_GT(valueOf(cloud, 0, "curvature"), 0.0);
}

TEST_F(RepairApp, ReportsIslandsLoopsAndLines)
{
  save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(
      0,
      inspectQuickly("caps.ply", {"--report", folder_.path("report.json")}).exit_code);
  const nlohmann::json json = report();
  EXPECT_EQ("ICM3", json.at("class"));
  ASSERT_EQ(2U, json.at("islands").size());
  EXPECT_GT(json.at("islands")[0].at("triangles"), 100);
  EXPECT_EQ(false, json.at("islands")[0].at("flipped"));
  ASSERT_EQ(2U, json.at("loops").size());
  for (const auto& loop : json.at("loops")) {
    EXPECT_EQ("island rim", loop.at("class"));
    EXPECT_GT(loop.at("confidence"), 0.4);
    EXPECT_LT(loop.at("D_relative"), 1.0);
    EXPECT_GT(loop.at("faced"), 0.9);
  }
  ASSERT_GT(json.at("lines").size(), 4U);
  EXPECT_GT(json.at("lines")[0].at("quality"), 0.0);
  EXPECT_TRUE(json.at("lines")[0].at("target").is_object());
  EXPECT_GT(json.at("free_points"), 50);
  EXPECT_GE(json.at("stages").size(), 3U);
}

TEST_F(RepairApp, GivesTheSameFilesForAnyNumberOfThreads)
{
  save(folder_.path("caps.ply"), twoCaps());
  std::vector<std::string> first;
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(0, inspectQuickly("caps.ply", {"--threads", threads}).exit_code);
    std::vector<std::string> files;
    for (const std::string& name : found())
      files.push_back(readFile(foundFile(name)));
    if (first.empty())
      first = files;
    EXPECT_TRUE(first == files) << threads;
  }
}

TEST_F(RepairApp, TakesASeparateCloudOfFreePoints)
{
  save(folder_.path("hole.ply"),
       test::toPolygonMesh(test::withoutTriangles(test::icosphere(3), {0, 1, 2, 3})));
  save(folder_.path("free.pcd"), colouredCloud(50));
  const std::vector<std::string> options{"--free-points",
                                         folder_.path("free.pcd"),
                                         "--mode",
                                         "full",
                                         "--report",
                                         folder_.path("report.json")};
  const RunResult result = inspectQuickly("hole.ply", options);
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(50, report().at("free_points"));
  EXPECT_EQ("full", report().at("parameters").at("mode"));
  const auto cloud = loadCloud(foundFile("free_points.pcd")).mesh.cloud;
  EXPECT_EQ(-1, valueOf(cloud, 0, "cloud_index"));
}

TEST_F(RepairApp, TellsWhatChangedOnReading)
{
  test::Shape shape = test::grid(6, 6);
  shape.triangles = test::randomlyReversed(shape.triangles, 3);
  save(folder_.path("mixed.ply"), test::toPolygonMesh(shape));
  const RunResult result = inspectQuickly("mixed.ply");
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(contains(result.output, "wound the other way")) << result.output;
}

TEST_F(RepairApp, TheSensorPositionOfAFileTellsTheOuterSide)
{
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\n"
      "property float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\n"
      "element camera 1\nproperty float view_px\n"
      "property float view_py\nproperty float view_pz\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  for (const auto& [camera, flipped] :
       {std::pair{"0 0 9\n", false}, std::pair{"0 0 -9\n", true}}) {
    writeFile(folder_.path("in.ply"), head + camera);
    const RunResult result =
        inspectQuickly("in.ply", {"--report", folder_.path("report.json")});
    ASSERT_EQ(0, result.exit_code) << result.errors;
    EXPECT_EQ("sensor position", report().at("islands")[0].at("rule"));
    EXPECT_EQ(flipped, report().at("islands")[0].at("flipped"));
  }
}

TEST_F(RepairApp, AClosedMeshLacksNothing)
{
  save(folder_.path("closed.ply"), colouredSphere());
  ASSERT_EQ(0, inspectQuickly("closed.ply").exit_code);
  EXPECT_TRUE(std::filesystem::exists(foundFile("islands.vtk")));
  for (const char* name : {"loops.vtk", "lines.vtk", "line_points.pcd", "origins.pcd"})
    EXPECT_FALSE(std::filesystem::exists(foundFile(name))) << name;
}

TEST_F(RepairApp, LeavesNoFileOfAnEarlierRunThatWouldMislead)
{
  save(folder_.path("caps.ply"), twoCaps());
  save(folder_.path("closed.ply"), colouredSphere());
  ASSERT_EQ(0, inspectQuickly("caps.ply").exit_code);
  writeFile(foundFile("notes.txt"), "mine");
  ASSERT_EQ(0, inspectQuickly("closed.ply").exit_code);
  EXPECT_FALSE(std::filesystem::exists(foundFile("lines.vtk")));
  EXPECT_EQ("mine", readFile(foundFile("notes.txt")));
}

TEST_F(RepairApp, ParametersReachTheMethod)
{
  save(folder_.path("hole.ply"),
       test::toPolygonMesh(test::withoutTriangles(test::icosphere(3), {0, 1, 2, 3})));
  for (const auto& [edges, name] :
       {std::pair{"3", "complex_holes"}, std::pair{"12", "simple_holes"}}) {
    const std::vector<std::string> options{
        "--simple-edges", edges, "--report", folder_.path("report.json")};
    ASSERT_EQ(0, inspectQuickly("hole.ply", options).exit_code);
    EXPECT_GT(report().at(name), 0) << edges;
  }
}

TEST_F(RepairApp, RefusesBadUsageWithOneLineAndNoFile)
{
  save(folder_.path("caps.ply"), twoCaps());
  const std::vector<std::vector<std::string>> refused = {{"--mode", "heavy"},
                                                         {"--trust", "1"},
                                                         {"--room", "1"},
                                                         {"--falloff-exponent", "0"},
                                                         {"--interpolation", "-1"},
                                                         {"--near", "nan"},
                                                         {"--line-spacing", "0"},
                                                         {"--hole-threshold", "0"},
                                                         {"--filling", "glue"},
                                                         {"--edge-length", "0"},
                                                         {"--bridge-spacing", "0"},
                                                         {"--greatest-hole", "-1"},
                                                         {"--bridges", "b.vtk"},
                                                         {"--labels"},
                                                         {"--size", "0x5"},
                                                         {"--view", "0,0,0"},
                                                         {"--view-up", "1,2"},
                                                         {"repaired.ply", "third.ply"},
                                                         {"--free-points", "none.pcd"}};
  for (const auto& options : refused) {
    const RunResult result = inspectQuickly("caps.ply", options);
    EXPECT_EQ(1, result.exit_code) << options.front();
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ(std::vector<std::string>{"caps.ply"}, folder_.names());
  }
}

TEST_F(RepairApp, SaysWhatCanBeAskedForWhenNothingIs)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = runApp("pcl_repair_holes", {folder_.path("caps.ply")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  EXPECT_TRUE(contains(result.errors, "--inspect DIR")) << result.errors;
}

TEST_F(RepairApp, TheReportMayLieInTheNewFolder)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result =
      inspectQuickly("caps.ply", {"--report", foundFile("report.json")});
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(nlohmann::json::accept(readFile(foundFile("report.json"))));
}

TEST_F(RepairApp, NeverWritesOverItsInput)
{
  std::filesystem::create_directory(folder_.path("found"));
  save(foundFile("islands.vtk"), twoCaps());
  const std::string before = readFile(foundFile("islands.vtk"));
  const RunResult result = inspectQuickly("found/islands.vtk");
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  EXPECT_TRUE(before == readFile(foundFile("islands.vtk")));
}

TEST_F(RepairApp, RefusesACloudInPlaceOfAMesh)
{
  save(folder_.path("cloud.ply"), colouredCloud(100));
  save(folder_.path("cloud.pcd"), colouredCloud(100));
  for (const char* name : {"cloud.ply", "cloud.pcd"}) {
    const RunResult result = inspectQuickly(name);
    EXPECT_EQ(1, result.exit_code) << name;
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ(2U, folder_.names().size());
  }
}

TEST_F(RepairApp, AnInterruptLeavesNothing)
{
  save(folder_.path("in.ply"), test::toPolygonMesh(test::terrain(400, 400)));
  for (const int delay_ms : {20, 100, 300}) {
    const RunResult result = runAndInterrupt(
        "pcl_repair_holes",
        {folder_.path("in.ply"), "--inspect", folder_.path("found"), "--no-pictures"},
        delay_ms);
    // A fast machine may be through before the signal, a slow one not yet ready for it.
    if (result.exit_code == 0) {
      std::filesystem::remove_all(folder_.path("found"));
      continue;
    }
    EXPECT_TRUE(result.exit_code == 130 || result.exit_code == -1) << result.exit_code;
    EXPECT_EQ(std::vector<std::string>{"in.ply"}, folder_.names());
  }
}

TEST_F(RepairApp, WritesTheFilesWithoutPicturesWhereThereIsNoDisplay)
{
  save(folder_.path("caps.ply"), twoCaps());
  const std::string path = std::getenv("PATH");
  unsetenv("DISPLAY");
  setenv("PATH", "/nowhere", 1);
  const RunResult result = inspect("caps.ply");
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(0, result.exit_code);
  EXPECT_TRUE(contains(result.errors, "pictures were left out")) << result.errors;
  EXPECT_EQ(ALL_WITHOUT_PICTURES, found());
}

TEST_F(RepairApp, InspectsARealScan)
{
  const std::string scan = test::sharedData("range_maps/lato000.ply");
  SKIP_WITHOUT_DATA(scan);
  const RunResult result = runApp("pcl_repair_holes",
                                  {scan,
                                   "--inspect",
                                   folder_.path("found"),
                                   "--no-pictures",
                                   "--report",
                                   folder_.path("report.json")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ("ICM3", report().at("class"));
  EXPECT_GE(report().at("islands").size(), 9U);
  EXPECT_GE(report().at("loops").size(), 18U);
  EXPECT_EQ(ALL_WITHOUT_PICTURES, found());
}

} // namespace
} // namespace app_test
