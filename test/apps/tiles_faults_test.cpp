// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bad input and faults in a run tile by tile.
#include "tiles_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace app_test {
namespace {

namespace fs = std::filesystem;

std::size_t
trianglesOf(const std::string& path)
{
  return loadMesh(path).mesh.polygons.size();
}

/** Cut off the last bytes of a file. */
void
shorten(const std::string& path, std::uintmax_t bytes)
{
  fs::resize_file(path, fs::file_size(path) - bytes);
}

TEST_F(TiledApp, AFileThatEndsEarlyIsRefused)
{
  for (const char* name : {"in.ply", "in.pcd"}) {
    save(folder_.path(name), colouredCloud(3000));
    shorten(folder_.path(name), 1000);
    expectRefused(tiled({name}, "out.ply"), name);
  }
  writeFile(folder_.path("ascii.pcd"),
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 1\nPOINTS 3\n"
            "DATA ascii\n0 0 0\n1 0 0\n");
  expectRefused(tiled({"ascii.pcd"}, "out.ply"), "ascii.pcd");
  expectRefused(tiled({"none.pcd"}, "out.ply"), "none.pcd");
}

TEST_F(TiledApp, TheSameFileTwiceIsRefused)
{
  save(folder_.path("a.ply"), colouredCloud(1500));
  fs::create_symlink("a.ply", folder_.path("link.ply"));
  for (const char* other : {"a.ply", "./a.ply", "link.ply"}) {
    expectRefused(tiled({"a.ply", other}, "out.ply"), "same file");
    expectRefused(step("cut", "tiles", {folder_.path("a.ply"), folder_.path(other)}),
                  "twice");
  }
  EXPECT_FALSE(fs::exists(folder_.path("tiles")));
}

TEST_F(TiledApp, TwoFilesWithTheSamePointsAreNoted)
{
  save(folder_.path("a.ply"), colouredCloud(1500));
  save(folder_.path("b.pcd"), colouredCloud(1500));
  const RunResult result = tiled({"a.ply", "b.pcd"}, "out.ply");
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_NE(std::string::npos, result.errors.find("same points")) << result.errors;
  EXPECT_EQ(3000U, app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud));
}

TEST_F(TiledApp, CloudsOfAFewPointsEndAsWithoutTiles)
{
  for (std::size_t count = 0; count <= 3; ++count) {
    SCOPED_TRACE(count);
    pcl::ccaa::Positions points = test::bumpySphere(3);
    points.resize(count);
    save(folder_.path("in.ply"), test::toRawCloud(points));
    const RunResult one = reconstruct("in.ply", "whole.ply");
    const RunResult result = tiled({"in.ply"}, "out.ply");
    EXPECT_EQ(one.exit_code, result.exit_code) << one.errors << result.errors;
    if (result.exit_code != 1) {
      EXPECT_EQ(count, app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud));
    }
  }
}

TEST_F(TiledApp, ATileWithAllPointsInOnePlaceIsKept)
{
  auto points = test::bumpySphere(3000);
  points.insert(points.begin() + 7, 2500, points[100]);
  points.insert(points.end(), 2500, pcl::ccaa::Position(300.0, 0.0, 0.0));
  const auto cloud = test::toRawCloud(points);
  save(folder_.path("in.ply"), cloud);
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "out.ply")));
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  expectSameField(cloud, mesh.cloud, "y");
  const auto triangles = test::toTriangles(mesh.polygons);
  EXPECT_EQ(0U, test::countBoundaryEdges(triangles));
  EXPECT_EQ(5996U, triangles.size());
}

TEST_F(TiledApp, ATileOfOnePointIsKept)
{
  auto points = test::bumpySphere(3000);
  points.insert(points.end(), 2500, pcl::ccaa::Position(300.0, 0.0, 0.0));
  points.emplace_back(600.0, 0.0, 0.0);
  const auto cloud = test::toRawCloud(points);
  save(folder_.path("in.ply"), cloud);
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"}, "out.ply", {"--report", folder_.path("report.json")})));
  const nlohmann::json facts = report();
  EXPECT_EQ(1, facts.at("shards").back().at("vertices"));
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  expectSameField(cloud, mesh.cloud, "x");
  EXPECT_EQ(5996U, mesh.polygons.size());
}

TEST_F(TiledApp, EmptySpaceBetweenTilesMakesNoDifference)
{
  auto points = test::bumpySphere(3000);
  for (const auto& point : test::shifted(test::bumpySphere(3000, 2), {1e4, -3e4, 5e3}))
    points.push_back(point);
  points.emplace_back(1e6, 1e6, 1e6);
  points.emplace_back(-1e5, 0.0, 0.0);
  points.emplace_back(-1e5, 0.0, 0.01);
  const auto cloud = test::toRawCloud(points);
  save(folder_.path("in.ply"), cloud);
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "out.ply")));
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  expectSameField(cloud, mesh.cloud, "x");
  const auto triangles = test::toTriangles(mesh.polygons);
  EXPECT_TRUE(test::isIcadm(triangles, points.size()));
  EXPECT_EQ(2U, test::countComponents(triangles));
}

/** The tip of a closed body reaches into the next cell of the grid. */
TEST_F(TiledApp, AFewPointsInACellOfTheirOwnAreNoTileAndNoHole)
{
  for (const std::size_t count : {1U, 2U, 5U, 9U}) {
    SCOPED_TRACE(count);
    auto points = test::fibonacciSphere(3000, 0.9);
    std::vector<double> heights;
    for (auto& p : points) {
      p = {p.z(), p.x(), p.y()};
      heights.push_back(p.x());
    }
    std::sort(heights.rbegin(), heights.rend());
    const double middle = 0.5 * (heights[count - 1] + heights[count]);
    const auto cloud =
        test::toRawCloud(test::shifted(points, {2.0 - middle, 1.0, 1.02}));
    save(folder_.path("in.ply"), cloud);
    ASSERT_TRUE(hasMeshed(
        tiled({"in.ply"}, "out.ply", {"--report", folder_.path("report.json")})));
    const nlohmann::json facts = report();
    for (const auto& shard : facts.at("shards"))
      EXPECT_GT(shard.at("vertices").get<std::size_t>(), 200U);
    const auto triangles =
        test::toTriangles(loadMesh(folder_.path("out.ply")).mesh.polygons);
    EXPECT_TRUE(test::isIcadm(triangles, 3000));
    EXPECT_EQ(5996U, triangles.size());
  }
}

TEST_F(TiledApp, PointsThatAreNotFiniteAreKeptWithoutTriangles)
{
  const auto cloud =
      test::toRawCloud(test::withNonFinite(test::bumpySphere(4000), 100));
  save(folder_.path("in.ply"), cloud);
  const RunResult result = tiled({"in.ply"}, "out.ply");
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_NE(std::string::npos, result.errors.find("100")) << result.errors;
  const auto mesh = loadMesh(folder_.path("out.ply")).mesh;
  for (const char* axis : {"x", "y", "z"})
    expectSameField(cloud, mesh.cloud, axis);
  for (const auto& polygon : mesh.polygons)
    for (const auto corner : polygon.vertices)
      ASSERT_TRUE(std::isfinite(valueOf(cloud, std::size_t(corner), "x")));
  save(
      folder_.path("none.ply"),
      test::toRawCloud(pcl::ccaa::Positions(
          5, pcl::ccaa::Position::Constant(std::numeric_limits<double>::quiet_NaN()))));
  const RunResult none = tiled({"none.ply"}, "of_none.ply");
  EXPECT_EQ(1, none.exit_code) << none.errors;
}

TEST_F(TiledApp, AScanThatCoversOneTileOnlyIsPartOfTheWhole)
{
  const auto all = test::bumpySphere(4000);
  pcl::ccaa::Positions most, corner;
  for (const auto& point : all)
    (point.x() > 0.1 && point.y() > 0.1 && point.z() > 0.1 ? corner : most)
        .push_back(point);
  save(folder_.path("all.ply"), test::toRawCloud(all));
  save(folder_.path("most.ply"), test::toRawCloud(most));
  save(folder_.path("corner.ply"), test::toRawCloud(corner));
  ASSERT_TRUE(hasMeshed(tiled({"all.ply"}, "whole.ply")));
  ASSERT_TRUE(hasMeshed(tiled({"most.ply", "corner.ply"}, "out.ply")));
  EXPECT_EQ(trianglesOf(folder_.path("whole.ply")),
            trianglesOf(folder_.path("out.ply")));
}

TEST_F(TiledApp, AFolderOfAnotherRunIsRefused)
{
  save(folder_.path("in.ply"), colouredCloud(2500));
  save(folder_.path("other.ply"), colouredCloud(2500, 2));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "tiles")));
  const Files before = shardsIn("tiles");
  expectRefused(intoFolder({"other.ply"}, "tiles"), "other inputs or other parameters");
  expectRefused(intoFolder({"in.ply"}, "tiles", {"--tiles=1200"}), "other parameters");
  expectRefused(intoFolder({"in.ply"}, "tiles", {"--neighbors", "12"}),
                "other parameters");
  const std::string plan = folder_.path("tiles/plan.json");
  std::string text = readFile(plan);
  const std::size_t version = text.find("\"version\": \"") + 12;
  text.replace(version, text.find('"', version) - version, "0.0.1");
  writeFile(plan, text);
  expectRefused(intoFolder({"in.ply"}, "tiles"), "0.0.1");
  expectRefused(step("mesh", "tiles", {"0"}), "0.0.1");
  EXPECT_TRUE(before == shardsIn("tiles"));
}

TEST_F(TiledApp, AnInputThatHasChangedIsNoticed)
{
  save(folder_.path("in.ply"), colouredCloud(2500));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "tiles")));
  save(folder_.path("in.ply"), colouredCloud(2500, 2)); // of the same size
  expectRefused(intoFolder({"in.ply"}, "tiles"), "other inputs or other parameters");
}

/** Files of another run that lie in the folder, as after a plan was removed. */
TEST_F(TiledApp, FilesOfAnotherRunAreNotTakenForThoseOfThisOne)
{
  save(folder_.path("in.ply"), colouredCloud(2500));
  save(folder_.path("other.ply"), colouredCloud(2500, 2));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "tiles")));
  fs::remove(folder_.path("tiles/plan.json"));
  expectRefused(intoFolder({"other.ply"}, "tiles"),
                "belongs to a run with other inputs");
}

TEST_F(TiledApp, DamagedFilesOfStepsAreTold)
{
  save(folder_.path("in.ply"), colouredCloud(2500));
  ASSERT_TRUE(
      hasMeshed(step("cut", "tiles", {folder_.path("in.ply"), "--tiles=1000"})));
  ASSERT_TRUE(hasMeshed(step("mesh", "tiles", {"0"})));
  const std::string points = folder_.path("tiles/000000.points");
  const std::string mesh = folder_.path("tiles/000000.mesh");
  const std::string whole_points = readFile(points), whole_mesh = readFile(mesh);
  for (const double share : {0.0, 0.001, 0.3, 0.999}) {
    SCOPED_TRACE(share);
    const auto cut = [&](const std::string& bytes) {
      return bytes.substr(0, std::size_t(share * double(bytes.size())));
    };
    writeFile(mesh, cut(whole_mesh));
    expectRefused(step("join", "tiles", {"0"}), "000000.mesh");
    fs::remove(mesh);
    writeFile(points, cut(whole_points));
    expectRefused(step("mesh", "tiles", {"0"}), "000000.points");
    EXPECT_FALSE(fs::exists(mesh));
    writeFile(points, whole_points);
  }
  expectRefused(step("join", "tiles", {"0"}), "000000.mesh");
  expectRefused(step("mesh", "tiles", {"99"}), "no tile 99");
  expectRefused(step("mesh", "tiles", {}), "number of a tile");
  expectRefused(step("knit", "tiles"), "no step 'knit'");
  expectRefused(step("mesh", "elsewhere", {"0"}), "has not been cut");
  shorten(folder_.path("tiles/plan.json"), 100);
  expectRefused(step("mesh", "tiles", {"0"}), "damaged");
}

TEST_F(TiledApp, ACutShardIsTold)
{
  save(folder_.path("in.ply"), colouredCloud(2500));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "tiles")));
  const std::string shard = folder_.path("tiles/000001.ply");
  const std::string whole = readFile(shard);
  for (const std::size_t kept : {std::size_t{0},
                                 std::size_t{40},
                                 whole.size() / 2,
                                 whole.size() - 13,
                                 whole.size() - 1}) {
    SCOPED_TRACE(kept);
    writeFile(shard, whole.substr(0, kept));
    expectRefused(
        tiled({"in.ply"}, "out.ply", {"--tile-folder", folder_.path("tiles")}),
        "000001.ply");
  }
}

TEST_F(TiledApp, AKilledStepLeavesNoHalfFileAndGoesOn)
{
  save(folder_.path("in.ply"), colouredCloud(6000));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "whole")));
  // Killed as soon as some tile is meshed, and again with the next ones.
  for (int round = 0; round < 3; ++round) {
    const std::string mesh =
        folder_.path("tiles") + "/00000" + std::to_string(round) + ".mesh";
    runInShell("pcl_ccaa_reconstruct --tiles=1000 --threads 1 " +
               folder_.path("in.ply") + " --tile-folder " + folder_.path("tiles") +
               " & while kill -0 $! && ! test -e " + mesh +
               "; do sleep 0.002; done; kill -KILL $!; wait $!");
    ASSERT_TRUE(fs::exists(mesh));
    EXPECT_TRUE(shardsIn("tiles").empty());
  }
  const auto made = fs::last_write_time(folder_.path("tiles/plan.json"));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "tiles")));
  EXPECT_EQ(made, fs::last_write_time(folder_.path("tiles/plan.json")));
  EXPECT_TRUE(shardsIn("whole") == shardsIn("tiles"));
}

/** Files may have so many KiB at the most. */
TEST_F(TiledApp, NoRoomOnTheDiskIsToldAndGoingOnWorks)
{
  save(folder_.path("in.ply"), colouredCloud(3000));
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"}, "whole.ply", {"--tile-folder", folder_.path("whole")})));
  std::size_t refused = 0;
  for (const int kilobytes : {1, 8, 24, 40, 60, 90, 140}) {
    SCOPED_TRACE(kilobytes);
    const RunResult result = runInShell(
        "trap '' XFSZ; ulimit -f " + std::to_string(kilobytes) +
        "; exec pcl_ccaa_reconstruct --tiles=1000 " + folder_.path("in.ply") + " " +
        folder_.path("out.ply") + " --tile-folder " + folder_.path("tiles"));
    if (result.exit_code == 0)
      break;
    ++refused;
    expectRefused(result, "cannot write");
    EXPECT_TRUE(partsIn("tiles").empty());
  }
  EXPECT_GE(refused, 3U);
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"}, "out.ply", {"--tile-folder", folder_.path("tiles")})));
  EXPECT_TRUE(shardsIn("whole") == shardsIn("tiles"));
  EXPECT_TRUE(readFile(folder_.path("whole.ply")) == readFile(folder_.path("out.ply")));
}

TEST_F(TiledApp, OptionsThatDoNotGoTogetherAreRefused)
{
  save(folder_.path("in.ply"), colouredCloud(1500));
  expectRefused(tiled({"in.ply"}, "out.ply", {"--labels"}), "--tiles");
  expectRefused(tiled({"in.ply"}, "out.obj"), "PLY");
  expectRefused(tiled({"in.ply"}, "out.ply", {"--memory", "lots"}), "--memory");
  expectRefused(tiled({"in.ply"}, "out.ply", {"--tiles=10"}), "tiles");
  expectRefused(reconstruct("in.ply", "out.ply", {"--tile-folder", "x"}), "--tiles");
  expectRefused(
      runApp("pcl_ccaa_reconstruct", {"-", folder_.path("out.ply"), "--tiles"}),
      "standard input");
  fs::create_directory(folder_.path("out.ply.tiles"));
  EXPECT_EQ(1, tiled({"in.ply"}, "out.ply").exit_code);
  EXPECT_TRUE(fs::exists(folder_.path("out.ply.tiles")));
}

} // namespace
} // namespace app_test
