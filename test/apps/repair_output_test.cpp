// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repaired meshes of pcl_repair_holes and of
// pcl_ccaa_reconstruct --repair.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "repair_fixture.h"
#include "support/repair_shapes.h"
#include "support/shared_data.h"

#include <cstdlib>

namespace app_test {
namespace {

class RepairOutput : public RepairApp {
protected:
  RunResult
  repair(const std::string& input,
         const std::string& output,
         const std::vector<std::string>& options = {})
  {
    return runApp(
        "pcl_repair_holes", {folder_.path(input), folder_.path(output)}, options);
  }

  std::vector<std::string>
  withReport() const
  {
    return {"--report", folder_.path("report.json")};
  }

  test::Topology
  topologyOf(const std::string& name) const
  {
    return test::topologyOf(
        test::toTriangles(loadMesh(folder_.path(name)).mesh.polygons));
  }
};

bool
contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST_F(RepairOutput, JoinsIslandsToAClosedSurface)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = repair("caps.ply", "out.ply", withReport());
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ("", result.errors);
  EXPECT_TRUE(isOneLineWithVerdict(result.output)) << result.output;
  EXPECT_TRUE(contains(result.output, "ICM3 -> ICM1, 2 islands -> 1")) << result.output;
  const test::Topology found = topologyOf("out.ply");
  EXPECT_EQ(1U, found.components);
  EXPECT_EQ(2, found.characteristic);
  EXPECT_EQ((std::vector<std::string>{"caps.ply", "out.ply", "report.json"}),
            folder_.names());
}

TEST_F(RepairOutput, ReportsEverythingThatWasDone)
{
  save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(0, repair("caps.ply", "out.ply", withReport()).exit_code);
  const nlohmann::json json = report();
  EXPECT_EQ(true, json.at("complete"));
  EXPECT_EQ(0, json.at("shortfalls"));
  EXPECT_EQ("ICM3", json.at("before").at("class"));
  EXPECT_EQ("ICM1", json.at("after").at("class"));
  ASSERT_EQ(2U, json.at("islands").size());
  EXPECT_GT(json.at("islands")[0].at("area"), 1.0);
  ASSERT_EQ(2U, json.at("loops").size());
  EXPECT_EQ("island rim", json.at("loops")[0].at("class"));
  ASSERT_GT(json.at("bridges").size(), 1U);
  EXPECT_GT(json.at("bridges")[0].at("quality"), 0.0);
  ASSERT_GT(json.at("holes").size(), 1U);
  EXPECT_EQ(true, json.at("holes")[0].at("closed"));
  EXPECT_NE("", json.at("holes")[0].at("filling"));
  const auto& triangles = json.at("triangles");
  EXPECT_EQ(triangles.at("new"),
            triangles.at("fan").get<int>() + triangles.at("minimum_weight").get<int>() +
                triangles.at("completion").get<int>());
  EXPECT_EQ("automatic", json.at("parameters").at("filling"));
  EXPECT_EQ(false, json.at("before").at("watertight"));
  EXPECT_EQ(json.at("before").at("islands"), json.at("before").at("pieces"));
  EXPECT_EQ(json.at("after").at("islands"), json.at("after").at("pieces"));
  EXPECT_GE(json.at("steps").size(), 3U);
}

TEST_F(RepairOutput, KeepsAllFieldsAndTriangles)
{
  pcl::PolygonMesh mesh = colouredSphere();
  mesh.polygons.erase(mesh.polygons.begin(), mesh.polygons.begin() + 4);
  save(folder_.path("in.ply"), mesh);
  ASSERT_EQ(0, repair("in.ply", "out.ply").exit_code);
  const auto before = loadMesh(folder_.path("in.ply")).mesh;
  const auto after = loadMesh(folder_.path("out.ply")).mesh;
  ASSERT_EQ(before.cloud.point_step, after.cloud.point_step);
  ASSERT_LE(before.cloud.data.size(), after.cloud.data.size());
  EXPECT_TRUE(std::equal(
      before.cloud.data.begin(), before.cloud.data.end(), after.cloud.data.begin()));
  EXPECT_EQ(0U,
            test::countMissing(test::toTriangles(before.polygons),
                               test::toTriangles(after.polygons)));
}

TEST_F(RepairOutput, WritesEveryFormat)
{
  save(folder_.path("caps.ply"), twoCaps());
  for (const char* name : {"out.ply", "out.vtk", "out.obj", "out.stl"}) {
    ASSERT_EQ(0, repair("caps.ply", name).exit_code) << name;
    EXPECT_EQ(2, topologyOf(name).characteristic) << name;
  }
}

TEST_F(RepairOutput, WritesBridgesWithNormals)
{
  save(folder_.path("caps.ply"), twoCaps());
  const std::vector<std::string> options{"--bridges", folder_.path("bridges.vtk")};
  ASSERT_EQ(0, repair("caps.ply", "out.ply", options).exit_code);
  const auto cloud = loadMesh(folder_.path("bridges.vtk")).mesh.cloud;
  ASSERT_GT(app::pointCount(cloud), 4U);
  EXPECT_GT(valueOf(cloud, 0, "quality"), 0.0);
  EXPECT_NE(valueOf(cloud, 0, "begin_island"), valueOf(cloud, 0, "end_island"));
  double along = 0.0;
  for (const std::string axis : {"x", "y", "z"})
    along += valueOf(cloud, 0, axis) * valueOf(cloud, 0, "normal_" + axis);
  EXPECT_GT(along, 0.5);
  EXPECT_TRUE(contains(readFile(folder_.path("bridges.vtk")), "LINES"));
}

TEST_F(RepairOutput, WritesBridgesOfAMeshThatNeedsNone)
{
  save(folder_.path("closed.ply"), colouredSphere());
  const std::vector<std::string> options{"--bridges", folder_.path("bridges.vtk")};
  EXPECT_EQ(0, repair("closed.ply", "out.ply", options).exit_code);
  EXPECT_TRUE(contains(readFile(folder_.path("bridges.vtk")), "LINES 0 0"));
}

TEST_F(RepairOutput, LabelsTrianglesByOrigin)
{
  save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(0, repair("caps.ply", "out.ply", {"--labels"}).exit_code);
  EXPECT_TRUE(contains(readFile(folder_.path("out.ply")), "origin"));
  const RunResult refused = repair("caps.ply", "other.obj", {"--labels"});
  EXPECT_EQ(1, refused.exit_code);
  EXPECT_TRUE(isOneLine(refused.errors));
}

TEST_F(RepairOutput, EndsWithTwoAndAReasonWhenSomethingIsLeftOpen)
{
  save(folder_.path("band.ply"), test::toPolygonMesh(test::moebiusBand(40)));
  const RunResult result = repair("band.ply", "out.ply");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  EXPECT_TRUE(contains(result.errors, "1 boundary loop is left open because its"))
      << result.errors;
  EXPECT_TRUE(contains(result.errors, "at point ")) << result.errors;
  EXPECT_EQ(1U, topologyOf("out.ply").borders);
}

TEST_F(RepairOutput, ParametersReachTheRepair)
{
  save(folder_.path("caps.ply"), twoCaps());
  const std::vector<std::pair<std::string, nlohmann::json>> parameters{
      {"refine", false}, {"fair", false}, {"filling", "fan"}};
  std::vector<std::string> options = withReport();
  options.emplace_back("--pure");
  repair("caps.ply", "out.ply", options);
  for (const auto& [name, value] : parameters)
    EXPECT_EQ(value, report().at("parameters").at(name)) << name;
  EXPECT_GT(report().at("triangles").at("fan"), 0);
}

TEST_F(RepairOutput, TakesFreePointsFromAnotherCloud)
{
  save(folder_.path("hole.ply"),
       test::toPolygonMesh(test::withoutTriangles(test::icosphere(3), {0, 1, 2, 3})));
  save(folder_.path("free.pcd"), colouredCloud(50));
  std::vector<std::string> options = withReport();
  options.insert(options.end(), {"--free-points", folder_.path("free.pcd")});
  const RunResult result = repair("hole.ply", "out.ply", options);
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(50, report().at("free_points"));
}

TEST_F(RepairOutput, RepairsAndInspectsInOneRun)
{
  save(folder_.path("caps.ply"), twoCaps());
  std::vector<std::string> options = withReport();
  options.insert(options.end(), {"--inspect", folder_.path("found"), "--no-pictures"});
  const RunResult result = repair("caps.ply", "out.ply", options);
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(std::filesystem::exists(foundFile("loops.vtk")));
  EXPECT_EQ("ICM3", report().at("survey").at("class"));
  EXPECT_EQ(2, topologyOf("out.ply").characteristic);
}

TEST_F(RepairOutput, IsTheSameForAnyNumberOfThreads)
{
  save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(0, repair("caps.ply", "one.ply", {"--threads", "1"}).exit_code);
  ASSERT_EQ(0, repair("caps.ply", "two.ply", {"--threads", "2"}).exit_code);
  EXPECT_TRUE(readFile(folder_.path("one.ply")) == readFile(folder_.path("two.ply")));
}

TEST_F(RepairOutput, ASensorPositionTurnsIslandsButAddsNoField)
{
  writeFile(folder_.path("in.ply"),
            "ply\nformat ascii 1.0\nelement vertex 4\n"
            "property float x\nproperty float y\nproperty float z\n"
            "element face 2\nproperty list uchar int vertex_indices\n"
            "element camera 1\nproperty float view_px\n"
            "property float view_py\nproperty float view_pz\nend_header\n"
            "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n0 0 -9\n");
  repair("in.ply", "out.ply", withReport());
  EXPECT_EQ("sensor position", report().at("islands")[0].at("rule"));
  EXPECT_FALSE(contains(readFile(folder_.path("out.ply")), "vp_x"));
}

TEST_F(RepairOutput, RefusesBadInputAndWritesNothing)
{
  save(folder_.path("cloud.ply"), colouredCloud(100));
  save(folder_.path("caps.ply"), twoCaps());
  const std::vector<std::vector<std::string>> refused{{"cloud.ply", "out.ply"},
                                                      {"none.ply", "out.ply"},
                                                      {"caps.ply", "out.xyz"},
                                                      {"caps.ply", "caps.ply"},
                                                      {"caps.ply", "nowhere/out.ply"}};
  for (const auto& files : refused) {
    const RunResult result = repair(files[0], files[1]);
    EXPECT_EQ(1, result.exit_code) << files[0] << " " << files[1];
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ((std::vector<std::string>{"caps.ply", "cloud.ply"}), folder_.names());
  }
}

TEST_F(RepairOutput, AnInterruptLeavesNothing)
{
  save(folder_.path("in.ply"), test::toPolygonMesh(test::terrain(400, 400)));
  for (const int delay_ms : {20, 100, 300}) {
    const RunResult result =
        runAndInterrupt("pcl_repair_holes",
                        {folder_.path("in.ply"), folder_.path("out.ply")},
                        delay_ms);
    // A fast machine may be through before the signal, a slow one not yet ready for it.
    if (result.exit_code == 0 || result.exit_code == 2) {
      std::filesystem::remove(folder_.path("out.ply"));
      continue;
    }
    EXPECT_TRUE(result.exit_code == 130 || result.exit_code == -1) << result.exit_code;
    EXPECT_EQ(std::vector<std::string>{"in.ply"}, folder_.names());
  }
}

TEST_F(RepairOutput, RepairsTheRawBunny)
{
  const std::string bunny = test::sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(bunny);
  const RunResult result =
      runApp("pcl_repair_holes", {bunny, folder_.path("bunny.ply")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const test::Topology found = topologyOf("bunny.ply");
  EXPECT_EQ(1U, found.components);
  EXPECT_EQ(2, found.characteristic);
}

class ReconstructAndRepair : public RepairOutput {
protected:
  /** A sphere of points with a wide belt missing, where no triangle is made. */
  void
  saveCaps()
  {
    pcl::PolygonMesh mesh = test::toPolygonMesh(
        test::inPieces(test::icosphere(5), [](const pcl::ccaa::Position& p) {
          return std::abs(p.z()) < 0.3 ? -1 : p.z() > 0.0 ? 1 : 0;
        }));
    mesh.polygons.clear();
    save(folder_.path("caps.ply"), mesh);
  }

  RunResult
  reconstruct(const std::vector<std::string>& options)
  {
    return runApp("pcl_ccaa_reconstruct",
                  {folder_.path("caps.ply"), folder_.path("out.ply")},
                  options);
  }
};

TEST_F(ReconstructAndRepair, MakesAClosedSurfaceOfACloud)
{
  saveCaps();
  const RunResult result = reconstruct(
      {"--repair", "--labels", "--normals", "--report", folder_.path("report.json")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const test::Topology found = topologyOf("out.ply");
  EXPECT_EQ(1U, found.components);
  EXPECT_EQ(2, found.characteristic);
  EXPECT_EQ(true, report().at("repair").at("complete"));
  EXPECT_EQ(0, report().at("boundary_loops"));
  EXPECT_EQ(0, report().at("genus"));
  EXPECT_EQ(true, report().at("watertight"));
  EXPECT_GT(report().at("repair").at("triangles").at("new"), 100);
}

TEST_F(ReconstructAndRepair, GoesWithTheBaseStageOnly)
{
  saveCaps();
  const RunResult result = reconstruct({"--repair", "--until", "filter"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
}

} // namespace
} // namespace app_test
