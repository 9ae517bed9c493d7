// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_repair_viewer as a user runs it, without a screen.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "inspect/inspection_colors.h"
#include "mesh/cloud_access.h"
#include "model_samples.h"
#include "pictures.h"
#include "repair_fixture.h"
#include "support/clouds.h"
#include "support/repair_shapes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace app_test {
namespace {

using pcl::TriangleOrigin;
using pcl::repair::BoundaryClass;

const app::Rgb HOLE_RED = app::colorOf(BoundaryClass::HOLE);
const app::Rgb NEW_BLUE = app::colorOf(TriangleOrigin::MINIMUM_WEIGHT);

/** Where the legend and where the model is in pictures of the size below. */
constexpr Columns LEGEND{0, 160};
constexpr Columns MODEL{170, 0};
constexpr const char* SIZE = "600x400";

class RenderRepairViewer : public testing::Test {
protected:
  RenderRepairViewer()
  {
    unsetenv("DISPLAY");
    const test::Shape sphere = test::icosphere(3);
    std::vector<std::size_t> facing_z;
    for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
      if (sphere.vertices[static_cast<std::size_t>(sphere.triangles[t][0])].z() > 0.85)
        facing_z.push_back(t);
    save(path("holed.ply"),
         test::toPolygonMesh(
             test::withoutFreeVertices(test::withoutTriangles(sphere, facing_z))));
    save(path("closed.ply"), test::toPolygonMesh(sphere));
    save(path("cloud.pcd"), test::toPolygonMesh(sphere).cloud);
  }

  std::string
  path(const std::string& name) const
  {
    return folder_.path(name);
  }

  RunResult
  view(const std::string& input, std::vector<std::string> options)
  {
    options.insert(options.begin(), path(input));
    if (std::find(options.begin(), options.end(), "--size") == options.end())
      options.insert(options.end(), {"--size", SIZE});
    options.emplace_back("--quiet");
    return runApp("pcl_repair_viewer", options);
  }

  /** The picture of a stage; fails the test when there is none. */
  Picture
  look(const std::string& input, std::vector<std::string> options)
  {
    const std::string file = path("picture.png");
    options.insert(options.end(), {"--screenshot", file});
    const RunResult result = view(input, options);
    EXPECT_EQ(0, result.exit_code) << result.errors;
    EXPECT_EQ("", result.errors);
    return decodePng(readFile(file));
  }

  TemporaryFolder folder_;
};

TEST_F(RenderRepairViewer, ShowsHolesOfAMeshInTheColourOfTheirClass)
{
  const Picture picture = look("holed.ply", {"--stage", "boundaries"});
  EXPECT_EQ(600, picture.width);
  EXPECT_EQ(400, picture.height);
  EXPECT_GT(countColor(picture, HOLE_RED, LEGEND), 50U);
  EXPECT_GT(countColor(picture, HOLE_RED, MODEL), 100U);
}

TEST_F(RenderRepairViewer, ShowsNewTrianglesInTheResultAlone)
{
  EXPECT_GT(countShaded(look("holed.ply", {}), NEW_BLUE, MODEL), 1000U);
  EXPECT_EQ(0U, countShaded(look("holed.ply", {"--stage", "mesh"}), NEW_BLUE, MODEL));
}

TEST_F(RenderRepairViewer, TakesAPictureOfEveryStageOfACloud)
{
  const RunResult result = view("cloud.pcd", {"--screenshots", path("stages")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const char* const names[] = {"1_cloud",
                               "2_start",
                               "3_filter",
                               "4_base",
                               "5_boundaries",
                               "6_lines",
                               "7_bridges",
                               "8_holes",
                               "9_result"};
  for (const std::string name : names)
    EXPECT_EQ(600, decodePng(readFile(path("stages/" + name + ".png"))).width) << name;
}

TEST_F(RenderRepairViewer, ShowsTheRolesOfThePointsOfAMesh)
{
  const Picture picture = look(
      "holed.ply",
      {"--points-only", "--stage", "filter", "--size", "1200x800", "--view", "0,0,1"});
  const Columns model{300, 0};
  EXPECT_GT(countColor(picture, app::ROLE_BOUNDARY, model), 30U);
  EXPECT_GT(countColor(picture, app::ROLE_INTERNAL, model), 100U);
}

TEST_F(RenderRepairViewer, SaysInTheLegendThatThereIsNothingToShow)
{
  const Picture closed = look("closed.ply", {"--stage", "boundaries"});
  EXPECT_EQ(0U, countColor(closed, HOLE_RED));
  EXPECT_NE(countColor(closed, {255, 255, 255}, LEGEND),
            countColor(
                look("holed.ply", {"--stage", "boundaries"}), {255, 255, 255}, LEGEND));
}

TEST_F(RenderRepairViewer, PassesParametersToTheMethod)
{
  const Picture picture = look("holed.ply", {"--greatest-hole", "3"});
  EXPECT_EQ(0U, countShaded(picture, NEW_BLUE, MODEL));
}

TEST_F(RenderRepairViewer, RefusesBadUsageWithOneLineAndNoFile)
{
  const std::string output = path("a.png");
  writeFile(path("line.xyz"), "0 0 0\n1 1 1\n");
  const std::vector<std::vector<std::string>> refused = {
      {},
      {path("missing.ply"), "--screenshot", output},
      {path("line.xyz"), "--screenshot", output},
      {path("holed.ply"), "--screenshot", output, "--stage", "mood"},
      {path("holed.ply"), "--screenshot", output, "--stage", "filter"},
      {path("cloud.pcd"), "--screenshot", output, "--stage", "mesh"},
      {path("holed.ply"), "--screenshot", output, "--size", "7"},
      {path("holed.ply"), "--screenshot", output, "--view", "0,0,0"},
      {path("holed.ply"), "--screenshot", output, "--trust", "2"},
      {path("holed.ply"), "--screenshot", path("a.jpg")},
      {path("holed.ply"), "--screenshot", path("no/such/folder.png")},
      {path("holed.ply"), "--screenshots", path("no/such/folder")},
      {path("holed.ply")}}; // there is no screen for a window
  for (const auto& arguments : refused) {
    const RunResult result = runApp("pcl_repair_viewer", arguments);
    EXPECT_EQ(1, result.exit_code) << testing::PrintToString(arguments);
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  }
  EXPECT_EQ(
      (std::vector<std::string>{"closed.ply", "cloud.pcd", "holed.ply", "line.xyz"}),
      folder_.names());
}

TEST_F(RenderRepairViewer, ShowsMapCoordinatesAsNearTheOrigin)
{
  const auto pictureAt = [&](const pcl::ccaa::Position& place) {
    pcl::PolygonMesh mesh = loadMesh(path("holed.ply")).mesh;
    const pcl::ccaa::PointView given = pcl::ccaa::positionView(mesh.cloud);
    mesh.cloud = test::toDoubleCloud(
        test::shifted(test::onGrid(pcl::ccaa::copyPositions(given).positions), place));
    save(path("map.ply"), mesh);
    EXPECT_EQ(0, this->view("map.ply", {"--screenshot", path("map.png")}).exit_code);
    return readFile(path("map.png"));
  };
  const std::string near = pictureAt({0, 0, 0});
  EXPECT_FALSE(near.empty());
  EXPECT_TRUE(near == pictureAt(test::MAP_PLACE));
}

} // namespace
} // namespace app_test
