// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PCL's own viewer shows what we write.
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include "app_runner.h"
#include "model_samples.h"
#include "pictures.h"
#include "render/display.h"
#include "repair_fixture.h"
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <sstream>
#include <thread>

extern char** environ; // NOLINT: POSIX

namespace app_test {
namespace {

constexpr app::Rgb RED{255, 0, 0};
constexpr app::Rgb GREEN{0, 255, 0};
constexpr app::Rgb WHITE{255, 255, 255};

/** Clipping range, focal point, position, view up, angle, window: the model fills it.
 */
constexpr const char* CAMERA =
    "-cam 0.1,100/9.5,9.5,0/9.5,-14,28/0,1,0/0.7/600,500/0,0";

constexpr std::chrono::seconds PATIENCE{20};

/** A command without quotes, started with its output thrown away. */
pid_t
start(const std::string& command)
{
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream_number : {1, 2})
    posix_spawn_file_actions_addopen(
        &actions, stream_number, "/dev/null", O_WRONLY, 0600);
  pid_t child = -1;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : -1;
}

/** The exit code; -1 for a program that is not there or crashed. */
int
waitFor(pid_t child)
{
  int state = 0;
  if (child < 0 || waitpid(child, &state, 0) != child)
    return -1;
  return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

/** A square whose left half is red and whose right half is green, with normals. */
pcl::PolygonMesh
redAndGreenSquare()
{
  pcl::PolygonMesh mesh = test::toPolygonMesh(test::grid(20, 20));
  pcl::PointCloud<pcl::PointXYZ> places;
  pcl::fromPCLPointCloud2(mesh.cloud, places);
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  for (const auto& place : places) {
    pcl::PointXYZRGBNormal point;
    point.getVector3fMap() = place.getVector3fMap();
    point.getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
    const bool left = place.x < 9.5F;
    point.r = left ? 255 : 0;
    point.g = left ? 0 : 255;
    point.b = 0;
    cloud.push_back(point);
  }
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  return mesh;
}

class RenderInPclViewer : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (waitFor(start("pcl_ply2vtk")) < 0)
      GTEST_SKIP() << "no pcl_viewer here: install pcl-tools";
    unsetenv("DISPLAY");
    display_ = std::make_unique<app::Display>();
    ASSERT_TRUE(display_->ready());
  }

  std::string
  path(const std::string& name) const
  {
    return folder_.path(name);
  }

  /** Start the viewer and wait until it shows what it should, or patience ends. */
  static bool
  shows(const std::string& arguments, const std::function<bool(const Picture&)>& wanted)
  {
    const pid_t viewer = start("pcl_viewer " + arguments);
    if (viewer < 0)
      return false;
    const auto end = std::chrono::steady_clock::now() + PATIENCE;
    bool seen = false;
    while (!seen && waitpid(viewer, nullptr, WNOHANG) == 0 &&
           std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      seen = wanted(grabScreen());
    }
    kill(viewer, SIGKILL);
    waitpid(viewer, nullptr, 0);
    return seen;
  }

  TemporaryFolder folder_;
  std::unique_ptr<app::Display> display_;
};

/** The square, and beside it as many blue points without a triangle. */
pcl::PolygonMesh
squareWithFreePoints()
{
  pcl::PolygonMesh mesh = redAndGreenSquare();
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  const std::size_t size = cloud.size();
  for (std::size_t i = 0; i < size; ++i) {
    auto point = cloud[i];
    point.y = -0.3F * point.y - 1.0F;
    point.r = point.g = 0;
    point.b = 255;
    cloud.push_back(point);
  }
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  return mesh;
}

/** A filled half of the window each: what dots could never cover. */
bool
hasRedAndGreenFaces(const Picture& picture)
{
  return countShaded(picture, RED) > 10000 && countShaded(picture, GREEN) > 10000;
}

bool
hasGreyFaces(const Picture& picture)
{
  return countShaded(picture, WHITE) > 20000;
}

bool
hasRedAndGreenDots(const Picture& picture)
{
  return countShaded(picture, RED) > 400 && countShaded(picture, GREEN) > 400;
}

TEST_F(RenderInPclViewer, ShowsPolygonsAndColoursOfVtk)
{
  save(path("a.vtk"), redAndGreenSquare());
  EXPECT_TRUE(shows(path("a.vtk") + " " + CAMERA, hasRedAndGreenFaces));
}

TEST_F(RenderInPclViewer, ShowsFreePointsOfVtk)
{
  save(path("a.vtk"), squareWithFreePoints());
  EXPECT_TRUE(shows(path("a.vtk") + " " + CAMERA, [](const Picture& picture) {
    return hasRedAndGreenFaces(picture) && countShaded(picture, {0, 0, 255}) > 100;
  }));
}

TEST_F(RenderInPclViewer, ShowsPolygonsAndColoursOfPlyAfterPclPly2vtk)
{
  save(path("a.ply"), redAndGreenSquare());
  ASSERT_EQ(0, waitFor(start("pcl_ply2vtk " + path("a.ply") + " " + path("a.vtk"))));
  EXPECT_TRUE(shows(path("a.vtk") + " " + CAMERA, hasRedAndGreenFaces));
}

TEST_F(RenderInPclViewer, ShowsPolygonsOfObjAndStlAfterPclConverter)
{
  for (const std::string name : {"a.obj", "a.stl"}) {
    save(path(name), redAndGreenSquare());
    ASSERT_EQ(0, waitFor(start("pcl_converter " + path(name) + " " + path("a.vtk"))));
    EXPECT_TRUE(shows(path("a.vtk") + " " + CAMERA, hasGreyFaces)) << name;
  }
}

TEST_F(RenderInPclViewer, ShowsColoursOfClouds)
{
  save(path("a.pcd"), redAndGreenSquare().cloud);
  EXPECT_TRUE(shows(path("a.pcd") + " -ps 3 " + CAMERA, hasRedAndGreenDots)) << "pcd";
  save(path("b.ply"), redAndGreenSquare().cloud);
  ASSERT_EQ(0, waitFor(start("pcl_ply2pcd " + path("b.ply") + " " + path("b.pcd"))));
  EXPECT_TRUE(shows(path("b.pcd") + " -ps 3 " + CAMERA, hasRedAndGreenDots)) << "ply";
}

TEST_F(RenderInPclViewer, ShowsNormalsOfAPcd)
{
  save(path("a.pcd"), redAndGreenSquare().cloud);
  const auto has_hairs = [](const Picture& picture) {
    return countColor(picture, WHITE) > 2000;
  };
  EXPECT_TRUE(
      shows(path("a.pcd") + " -normals 1 -normals_scale 2 " + CAMERA, has_hairs));
}

/** A sphere in two caps, inspected and repaired; one test for all files of this, for
 * the runs take their time. */
TEST_F(RenderInPclViewer, ShowsTheLayersOfAnInspectionAndBridges)
{
  save(path("caps.ply"), twoCaps());
  const RunResult run = runApp("pcl_repair_holes",
                               {path("caps.ply"),
                                path("whole.vtk"),
                                "--inspect",
                                path("found"),
                                "--no-pictures",
                                "--bridges",
                                path("bridges.vtk")});
  ASSERT_EQ(0, run.exit_code) << run.errors;
  const auto shows_all = [&](const std::vector<std::string>& names,
                             const std::string& options,
                             const std::vector<app::Rgb>& colors) {
    std::string arguments;
    for (const std::string& name : names)
      arguments += path(name) + " ";
    arguments += options + " -bc 255,255,255 "
                           "-cam 0.1,100/0,0,0/2,-3,1.5/0,0,1/0.7/800,650/0,0";
    return shows(arguments, [&](const Picture& picture) {
      return std::all_of(colors.begin(), colors.end(), [&](const app::Rgb& color) {
        return countShaded(picture, color) > 40;
      });
    });
  };
  const app::Rgb rim = app::colorOf(pcl::repair::BoundaryClass::ISLAND_RIM);
  const app::Rgb bridge = app::colorOfBridge(1.0);
  const app::Rgb hair = app::NORMAL_BLUE;
  const app::Rgb told_by_sight = {240, 220, 130};
  const app::Rgb attracted = {20, 140, 90};
  EXPECT_TRUE(shows_all({"found/loops.vtk",
                         "found/lines.vtk",
                         "found/line_normals.vtk",
                         "found/section.vtk"},
                        "",
                        {rim, bridge, hair, app::SECTION_BLACK}));
  EXPECT_TRUE(shows_all({"bridges.vtk"}, "", {bridge}));
  EXPECT_TRUE(shows_all({"found/slice.vtk"}, "", {app::colorOfTension(0.5)}));
  EXPECT_TRUE(shows_all({"found/islands.vtk"}, "", {told_by_sight}));
  EXPECT_TRUE(shows_all({"found/origins.pcd", "found/free_points.pcd"},
                        "-ps 4 -ps 4",
                        {attracted, app::FREE_POINT_VIOLET}));
  EXPECT_TRUE(shows_all({"found/line_points.pcd"}, "-ps 4", {bridge}));
}

} // namespace
} // namespace app_test
