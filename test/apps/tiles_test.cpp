// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what reconstructing tile by tile makes.
#include "io/wording.h"
#include "support/random_source.h"
#include "tiles_fixture.h"

#include <filesystem>
#include <regex>

namespace app_test {
namespace {

/** Sound, one closed piece without handles, outward, with every point. */
void
expectOneClosedBody(const pcl::PolygonMesh& mesh)
{
  const auto facts = expectSound(mesh);
  EXPECT_EQ(0U, facts.boundary_edges);
  EXPECT_EQ(1U, facts.components);
  EXPECT_EQ(0, facts.genus.value_or(-1));
  EXPECT_GT(facts.volume.value_or(-1.0), 0.0);
}

TEST_F(TiledApp, AClosedSurfaceComesOutClosedWithAllFieldsBitForBit)
{
  const pcl::PCLPointCloud2 cloud = colouredCloud(60000);
  save(folder_.path("in.pcd"), cloud);
  const RunResult result = tiled(
      {"in.pcd"}, "out.ply", {"--tiles=5000", "--report", folder_.path("report.json")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(isOneLineWithVerdict(result.output)) << result.output;
  EXPECT_EQ("", result.errors);
  EXPECT_EQ((std::vector<std::string>{"in.pcd", "out.ply", "report.json"}),
            folder_.names());
  EXPECT_GE(report().at("shards").size(), 12U);
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  EXPECT_EQ(mesh.polygons.size(), report().at("triangles"));
  for (const pcl::PCLPointField& field : cloud.fields)
    expectSameField(cloud, mesh.cloud, field.name);
  expectOneClosedBody(mesh);
}

TEST_F(TiledApp, ShardsAreTheSameForAnyThreadsAndMemory)
{
  save(folder_.path("in.ply"), colouredCloud(6000, 2));
  ASSERT_TRUE(hasMeshed(intoFolder({"in.ply"}, "one", {"--threads", "1"})));
  const Files shards = shardsIn("one");
  EXPECT_GE(shards.size(), 9U);
  ASSERT_TRUE(
      hasMeshed(intoFolder({"in.ply"}, "two", {"--threads", "2", "--memory", "1000"})));
  EXPECT_TRUE(shards == shardsIn("two"));
  ASSERT_TRUE(
      hasMeshed(intoFolder({"in.ply"}, "three", {"--threads", "3", "--memory", "8G"})));
  EXPECT_TRUE(shards == shardsIn("three"));
}

/** With so much noise nearly all disputes are one group. */
TEST_F(TiledApp, TilesThatWaitMakeASoundMeshForAnyNumberOfThreads)
{
  test::RandomSource random(1);
  pcl::ccaa::Positions points;
  for (int i = 0; i < 5000; ++i)
    points.emplace_back(i / 25 + 0.8 * random.normal(),
                        i % 25 + 0.8 * random.normal(),
                        0.8 * random.normal());
  save(folder_.path("in.ply"), test::toRawCloud(points));
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(2,
              intoFolder({"in.ply"},
                         threads,
                         {"--tiles=4000", std::string("--threads=") + threads})
                  .exit_code);
  // Behind the second colon are the tiles that one waits for.
  EXPECT_TRUE(
      std::regex_search(step("seams", "1").output, std::regex(": [0-9 ]+: [0-9]")));
  EXPECT_TRUE(shardsIn("1") == shardsIn("2"));
  ASSERT_TRUE(hasMeshed(step("merge", "1", {folder_.path("out.ply")})));
  expectSound(loadMesh(folder_.path("out.ply")).mesh);
}

TEST_F(TiledApp, ShardsAreTheSameForAnyOrderOfTheInputs)
{
  const pcl::PCLPointCloud2 cloud = colouredCloud(5000, 3);
  save(folder_.path("a.ply"), partOf(cloud, 0, 2000));
  save(folder_.path("b.pcd"), partOf(cloud, 2000, 2100));
  save(folder_.path("c.ply"), partOf(cloud, 2100, 5000));
  ASSERT_TRUE(hasMeshed(intoFolder({"a.ply", "b.pcd", "c.ply"}, "abc")));
  ASSERT_TRUE(hasMeshed(intoFolder({"c.ply", "a.ply", "b.pcd"}, "cab")));
  EXPECT_TRUE(shardsIn("abc") == shardsIn("cab"));
}

/** A cloud with two fields behind x, y and z. */
pcl::PCLPointCloud2
withTwoFields(const pcl::ccaa::Positions& points,
              const std::string& first,
              const std::string& second)
{
  test::FieldList fields = test::xyzFields();
  fields.emplace_back(first, pcl::PCLPointField::FLOAT32);
  fields.emplace_back(second, pcl::PCLPointField::FLOAT32);
  pcl::PCLPointCloud2 cloud = test::rawCloud(fields, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    test::setPosition(cloud, i * cloud.point_step, points[i]);
    test::setValue(cloud, i, "intensity", 0.5F * static_cast<float>(i));
    test::setValue(cloud, i, "ring", static_cast<float>(i % 7));
  }
  return cloud;
}

TEST_F(TiledApp, ShardsAreTheSameForAnyOrderOfInputsWithFieldsInAnotherOrder)
{
  pcl::ccaa::Positions points = test::bumpySphere(3000, 3);
  const pcl::ccaa::Positions last(points.begin() + 2000, points.end());
  points.resize(2000);
  save(folder_.path("a.ply"), withTwoFields(points, "ring", "intensity"));
  save(folder_.path("b.ply"), withTwoFields(last, "intensity", "ring"));
  ASSERT_TRUE(hasMeshed(intoFolder({"a.ply", "b.ply"}, "ab")));
  ASSERT_TRUE(hasMeshed(intoFolder({"b.ply", "a.ply"}, "ba")));
  EXPECT_TRUE(shardsIn("ab") == shardsIn("ba"));
}

TEST_F(TiledApp, PointsComeOutInTheOrderOfTheInputsThatWereGivenNow)
{
  const pcl::PCLPointCloud2 cloud = colouredCloud(3000, 3);
  const pcl::PCLPointCloud2 first = partOf(cloud, 0, 2000);
  const pcl::PCLPointCloud2 second = partOf(cloud, 2000, 3000);
  save(folder_.path("a.ply"), first);
  save(folder_.path("b.ply"), second);
  const std::vector<std::string> folder{"--tile-folder", folder_.path("tiles")};
  ASSERT_TRUE(hasMeshed(tiled({"a.ply", "b.ply"}, "ab.ply", folder)));
  ASSERT_TRUE(hasMeshed(tiled({"b.ply", "a.ply"}, "ba.ply", folder)));
  const auto ab = loadMesh(folder_.path("ab.ply")).mesh;
  const auto ba = loadMesh(folder_.path("ba.ply")).mesh;
  expectSameField(cloud, ab.cloud, "intensity");
  expectSameField(second, partOf(ba.cloud, 0, 1000), "intensity");
  expectSameField(first, partOf(ba.cloud, 1000, 3000), "intensity");
  auto moved = test::toTriangles(ba.polygons);
  for (pcl::ccaa::Triangle& triangle : moved)
    for (pcl::index_t& corner : triangle)
      corner = corner < 1000 ? corner + 2000 : corner - 1000;
  EXPECT_TRUE(test::sameTriangles(test::toTriangles(ab.polygons), moved));
}

TEST_F(TiledApp, ASecondRunInTheSameFolderMakesNothingAnew)
{
  save(folder_.path("in.ply"), colouredCloud(3000, 4));
  const std::vector<std::string> folder{"--tile-folder", folder_.path("tiles")};
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "1.ply", folder)));
  const auto madeAt = [&] {
    return std::filesystem::last_write_time(folder_.path("tiles/000000.ply"));
  };
  const auto before = madeAt();
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "2.ply", folder)));
  EXPECT_EQ(before, madeAt());
  EXPECT_TRUE(readFile(folder_.path("1.ply")) == readFile(folder_.path("2.ply")));
}

TEST_F(TiledApp, StepsOneByOneMakeTheSame)
{
  save(folder_.path("in.ply"), colouredCloud(3000, 5));
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"}, "1.ply", {"--tile-folder", folder_.path("at_once")})));
  ASSERT_TRUE(
      hasMeshed(step("cut", "steps", {folder_.path("in.ply"), "--tiles=1000"})));
  ASSERT_NO_FATAL_FAILURE(doSteps("steps", {}));
  EXPECT_TRUE(shardsIn("at_once") == shardsIn("steps"));
  ASSERT_TRUE(hasMeshed(step("merge", "steps", {folder_.path("2.ply")})));
  EXPECT_TRUE(readFile(folder_.path("1.ply")) == readFile(folder_.path("2.ply")));
}

TEST_F(TiledApp, EveryFileFormatMakesTheSameMesh)
{
  pcl::ccaa::Positions points = test::bumpySphere(3000, 6);
  for (auto& point : points) // few enough digits for text
    point = (1e4 * point).array().round() / 1e4;
  const pcl::PCLPointCloud2 cloud = test::toRawCloud(points);
  std::string ascii = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                      "WIDTH 3000\nHEIGHT 1\nPOINTS 3000\nDATA ascii\n";
  for (const auto& p : points)
    ascii += app::formatted("%.4f %.4f %.4f\n", p.x(), p.y(), p.z());
  writeFile(folder_.path("ascii.pcd"), ascii);
  save(folder_.path("binary.pcd"), cloud);
  save(folder_.path("in.ply"), cloud);
  save(folder_.path("in.xyz"), cloud);
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "ply.ply")));
  expectSameField(cloud, loadMesh(folder_.path("ply.ply")).mesh.cloud, "x");
  for (const char* name : {"ascii.pcd", "binary.pcd", "in.xyz"}) {
    ASSERT_TRUE(hasMeshed(tiled({name}, "out.ply"))) << name;
    EXPECT_TRUE(readFile(folder_.path("ply.ply")) == readFile(folder_.path("out.ply")))
        << name;
  }
}

TEST_F(TiledApp, MapCoordinatesStayExactDoubles)
{
  const auto points =
      test::shifted(test::onGrid(test::bumpySphere(6000, 7)), test::MAP_PLACE);
  const pcl::PCLPointCloud2 cloud = test::toDoubleCloud(points);
  ASSERT_TRUE(hasMeshed(tiledOf(cloud)));
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  for (const char* axis : {"x", "y", "z"})
    expectSameField(cloud, mesh.cloud, axis);
  pcl::PolygonMesh near = mesh;
  near.cloud =
      test::toRawCloud(test::shifted(positionsOf(mesh.cloud), -test::MAP_PLACE));
  expectOneClosedBody(near);
}

TEST_F(TiledApp, FieldsThatNotAllFilesHaveAreLeftOutAndTold)
{
  const pcl::PCLPointCloud2 cloud = colouredCloud(3000, 8);
  save(folder_.path("a.ply"), partOf(cloud, 0, 1500));
  save(folder_.path("b.ply"), test::toRawCloud(positionsOf(partOf(cloud, 1500, 3000))));
  const RunResult result = tiled({"a.ply", "b.ply"}, "out.ply");
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_NE(std::string::npos, result.errors.find("intensity")) << result.errors;
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  expectSameField(cloud, mesh.cloud, "z");
  EXPECT_FALSE(app::findField(mesh.cloud, "intensity"));
}

/** A flat open square seen from one side: only the viewpoint tells which. */
TEST_F(TiledApp, ViewpointsOfFilesTellTheOuterSideAcrossTiles)
{
  for (const int side : {1, -1}) {
    const auto points = test::terrainCloud(55, 9);
    for (const bool is_left : {true, false}) {
      std::string lines;
      std::size_t count = 0;
      for (const auto& p : points)
        if ((p.x() < 27.0) == is_left) {
          ++count;
          lines += std::to_string(p.x()) + " " + std::to_string(p.z()) + " " +
                   std::to_string(p.y()) + "\n";
        }
      const std::string n = std::to_string(count);
      writeFile(folder_.path(is_left ? "left.pcd" : "right.pcd"),
                "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " + n +
                    "\nHEIGHT 1\nVIEWPOINT " + (is_left ? "10 " : "40 ") +
                    std::to_string(100 * side) + " 27 1 0 0 0\nPOINTS " + n +
                    "\nDATA ascii\n" + lines);
    }
    ASSERT_TRUE(hasMeshed(tiled({"left.pcd", "right.pcd"}, "out.ply")));
    const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
    expectSound(mesh);
    const auto p = positionsOf(mesh.cloud);
    for (const auto& t : test::toTriangles(mesh.polygons)) {
      const auto normal = (p[std::size_t(t[1])] - p[std::size_t(t[0])])
                              .cross(p[std::size_t(t[2])] - p[std::size_t(t[0])]);
      ASSERT_GT(side * normal.y(), 0.0);
    }
  }
}

TEST_F(TiledApp, LinesOfAScannerAreJoinedAcrossCuts)
{
  const RunResult result =
      tiledOf(test::toRawCloud(test::sphereLines(8000, 10.0)), {"--tiles=8000"});
  EXPECT_NE(std::string::npos, result.output.find(" 0 open edges")) << result.output;
}

TEST_F(TiledApp, ACloudOfWhichMostPointsGetNoTriangleIsTold)
{
  const RunResult result = tiledOf(helix(), {"--tiles=2000"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.output.find(" UNUSED_POINTS)")) << result.output;
}

TEST_F(TiledApp, ANeckThatMayJoinTwoBodiesIsTold)
{
  const RunResult result = tiledOf(spheresThatTouch(2000, 0.03), {"--tiles=100000"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.output.find(" THIN_NECK)")) << result.output;
  EXPECT_NE(std::string::npos, result.errors.find(" (one is at ")) << result.errors;
}

TEST_F(TiledApp, HandlesThatMayBeTunnelsThroughThinPlacesAreTold)
{
  const RunResult result =
      tiledOf(test::toRawCloud(test::thinPlateCloud(30, 0.02)), {"--tiles=2000"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.output.find(" THIN_HANDLE)")) << result.output;
  EXPECT_NE(std::string::npos, result.errors.find("(one is at ")) << result.errors;
}

} // namespace
} // namespace app_test
