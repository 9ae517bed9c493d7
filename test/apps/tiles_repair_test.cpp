// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: repairing what is open tile by tile.
#include "tiles_fixture.h"

namespace app_test {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Positions;

/** Places of holes on the bumpy sphere of radius 1; with tiles of a unit or less
 * several lie across cuts, the coordinate planes among them. */
const Positions HOLES{{0.0, 0.7, 0.7},
                      {1.0, 0.0, 0.0},
                      {0.6, 0.5, 0.6},
                      {-0.6, -0.6, 0.5},
                      {0.1, -0.9, -0.3}};

Positions
withHoles(const Positions& points, const Positions& places, double radius)
{
  Positions left;
  for (const Position& point : points) {
    bool stays = true;
    for (const Position& place : places)
      stays = stays && (point.normalized() - place.normalized()).norm() > radius;
    if (stays)
      left.push_back(point);
  }
  return left;
}

pcl::PCLPointCloud2
sphereWithHoles()
{
  return test::toRawCloud(withHoles(test::bumpySphere(8000), HOLES, 0.12));
}

TEST_F(TiledApp, RepairClosesHolesWithinTilesAndAcrossCuts)
{
  const pcl::PCLPointCloud2 cloud = sphereWithHoles();
  save(folder_.path("in.ply"), cloud);
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"},
            "out.ply",
            {"--tiles=2000", "--repair", "--report", folder_.path("report.json")})));
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  const auto facts = expectSound(mesh);
  EXPECT_EQ(0U, facts.boundary_edges);
  EXPECT_EQ(1U, facts.components);
  EXPECT_EQ(0, facts.genus.value_or(-1));
  EXPECT_GT(facts.volume.value_or(-1.0), 0.0);
  EXPECT_GE(report().at("shards").size(), 8U);
  EXPECT_EQ(mesh.polygons.size(), report().at("triangles"));
  EXPECT_EQ(app::pointCount(mesh.cloud), report().at("vertices"));
  EXPECT_EQ(1, report().at("components"));
  EXPECT_EQ(0, report().at("open_edges"));
}

TEST_F(TiledApp, RepairTellsThatMuchIsNewUnlessAllIsToBeClosed)
{
  save(folder_.path("in.ply"),
       test::toRawCloud(
           withHoles(test::bumpySphere(4000), {Position(0.0, 0.0, 1.0)}, 1.2)));
  const RunResult told = tiled({"in.ply"}, "out.ply", {"--tiles=5000", "--repair"});
  EXPECT_EQ(2, told.exit_code);
  EXPECT_NE(std::string::npos, told.output.find("1 UNSUPPORTED")) << told.output;
  const RunResult asked = tiled(
      {"in.ply"}, "out.ply", {"--tiles=5000", "--repair", "--watertight", "--force"});
  EXPECT_EQ(0, asked.exit_code) << asked.errors;
  EXPECT_NE(std::string::npos, asked.output.find("complete: watertight, 1 piece\n"))
      << asked.output;
}

TEST_F(TiledApp, RepairKeepsAllPointsAndAppendsNewOnesWithTheirFields)
{
  pcl::PCLPointCloud2 cloud = colouredCloud(8000);
  Positions kept;
  std::vector<std::uint8_t> data;
  for (std::size_t i = 0; i < app::pointCount(cloud); ++i) {
    const Position point(
        valueOf(cloud, i, "x"), valueOf(cloud, i, "y"), valueOf(cloud, i, "z"));
    if (withHoles({point}, HOLES, 0.12).empty())
      continue;
    const auto from =
        cloud.data.begin() + static_cast<std::ptrdiff_t>(i * cloud.point_step);
    data.insert(data.end(), from, from + cloud.point_step);
  }
  cloud.width = static_cast<pcl::uindex_t>(data.size() / cloud.point_step);
  cloud.row_step = static_cast<pcl::uindex_t>(data.size());
  cloud.data = data;
  save(folder_.path("in.pcd"), cloud);
  ASSERT_TRUE(hasMeshed(tiled({"in.pcd"}, "out.ply", {"--tiles=2000", "--repair"})));
  const pcl::PCLPointCloud2 made = loadMesh(folder_.path("out.ply")).mesh.cloud;
  const std::size_t count = app::pointCount(cloud);
  ASSERT_GT(app::pointCount(made), count);
  for (const pcl::PCLPointField& field : cloud.fields)
    expectSameField(cloud, partOf(made, 0, count), field.name);
  for (std::size_t i = count; i < app::pointCount(made); ++i)
    ASSERT_TRUE(std::isfinite(valueOf(made, i, "x")));
}

TEST_F(TiledApp, RepairedShardsAreTheSameForAnyThreadsAndMemoryAndOrder)
{
  const pcl::PCLPointCloud2 cloud = sphereWithHoles();
  const std::size_t count = app::pointCount(cloud);
  save(folder_.path("a.ply"), partOf(cloud, 0, 2000));
  save(folder_.path("b.ply"), partOf(cloud, 2000, count));
  ASSERT_TRUE(hasMeshed(intoFolder(
      {"a.ply", "b.ply"}, "one", {"--tiles=2000", "--repair", "--threads", "1"})));
  ASSERT_TRUE(hasMeshed(
      intoFolder({"b.ply", "a.ply"},
                 "two",
                 {"--tiles=2000", "--repair", "--threads", "3", "--memory", "1000"})));
  EXPECT_TRUE(shardsIn("one") == shardsIn("two"));
}

TEST_F(TiledApp, RepairStepsOneByOneMakeTheSame)
{
  save(folder_.path("in.ply"), sphereWithHoles());
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"},
            "1.ply",
            {"--tiles=5000", "--repair", "--tile-folder", folder_.path("at_once")})));
  ASSERT_TRUE(hasMeshed(
      step("cut", "steps", {folder_.path("in.ply"), "--tiles=5000", "--repair"})));
  ASSERT_NO_FATAL_FAILURE(doSteps("steps", {"holes", "repair", "numbers"}));
  EXPECT_TRUE(shardsIn("at_once") == shardsIn("steps"));
  ASSERT_TRUE(hasMeshed(step("merge", "steps", {folder_.path("2.ply")})));
  EXPECT_TRUE(readFile(folder_.path("1.ply")) == readFile(folder_.path("2.ply")));
}

TEST_F(TiledApp, ShardsOfARepairHoldTheWholeMesh)
{
  save(folder_.path("in.ply"), sphereWithHoles());
  ASSERT_TRUE(hasMeshed(
      tiled({"in.ply"},
            "out.ply",
            {"--tiles=2000", "--repair", "--tile-folder", folder_.path("t")})));
  const pcl::PolygonMesh whole = loadMesh(folder_.path("out.ply")).mesh;
  std::size_t triangles = 0;
  std::map<std::size_t, Position> places;
  for (const auto& [name, bytes] : shardsIn("t")) {
    if (name == "index.json")
      continue;
    const pcl::PolygonMesh shard = loadMesh(folder_.path("t/" + name)).mesh;
    triangles += shard.polygons.size();
    for (std::size_t i = 0; i < app::pointCount(shard.cloud); ++i)
      places[static_cast<std::size_t>(valueOf(shard.cloud, i, "vertex_id"))] = {
          valueOf(shard.cloud, i, "x"),
          valueOf(shard.cloud, i, "y"),
          valueOf(shard.cloud, i, "z")};
  }
  EXPECT_EQ(whole.polygons.size(), triangles);
  ASSERT_EQ(app::pointCount(whole.cloud), places.size());
  EXPECT_EQ(places.size() - 1, places.rbegin()->first);
}

TEST_F(TiledApp, TheBorderOfATerrainStaysOpenAndIsNoFault)
{
  Positions points;
  for (const Position& point : test::terrainCloud(120))
    if ((point - Position(45, 45, point.z())).norm() > 4.0 &&
        (point - Position(20, 31, point.z())).norm() > 3.0)
      points.push_back(point);
  save(folder_.path("in.ply"), test::toRawCloud(points));
  const RunResult result =
      tiled({"in.ply"},
            "out.ply",
            {"--tiles=2000", "--repair", "--report", folder_.path("report.json")});
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_EQ(1, report().at("repair").at("outer_borders_beyond_a_tile"));
  EXPECT_EQ(2, report().at("repair").at("closed"));
  const auto facts = expectSound(loadMesh(folder_.path("out.ply")).mesh);
  EXPECT_EQ(1U, facts.boundary_loops.size());
}

TEST_F(TiledApp, AHoleTooLargeForATileIsLeftOpenAndTold)
{
  save(folder_.path("in.ply"),
       test::toRawCloud(withHoles(test::bumpySphere(12000), {{0.3, 0.8, 0.5}}, 0.9)));
  const RunResult result = tiled({"in.ply"}, "out.ply", {"--repair"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("BEYOND_A_TILE")) << result.errors;
  EXPECT_GT(expectSound(loadMesh(folder_.path("out.ply")).mesh).boundary_edges, 0U);
}

TEST_F(TiledApp, WishesOfARepairThatNeedTheWholeAreRefused)
{
  save(folder_.path("in.ply"), sphereWithHoles());
  expectRefused(tiled({"in.ply"},
                      "out.ply",
                      {"--tiles=2000", "--repair", "--drop-islands", "50"}),
                "--drop-islands");
  expectRefused(tiled({"in.ply"},
                      "out.ply",
                      {"--tiles=2000", "--repair", "--greatest-bridge", "5%"}),
                "units of the cloud");
  expectRefused(tiled({"in.ply"}, "out.ply", {"--watertight"}), "--repair");
}

TEST_F(TiledApp, RepairInMapCoordinatesStaysExact)
{
  Positions points = withHoles(test::bumpySphere(8000), HOLES, 0.12);
  points = test::onGrid(test::shifted(test::scaled(points, 10.0), test::MAP_PLACE));
  const pcl::PCLPointCloud2 cloud = test::toDoubleCloud(points);
  save(folder_.path("in.ply"), cloud);
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "out.ply", {"--tiles=2000", "--repair"})));
  const pcl::PolygonMesh mesh = loadMesh(folder_.path("out.ply")).mesh;
  EXPECT_EQ(0U, expectSound(mesh).boundary_edges);
  for (const char* axis : {"x", "y", "z"})
    expectSameField(cloud, partOf(mesh.cloud, 0, points.size()), axis);
  for (std::size_t i = points.size(); i < app::pointCount(mesh.cloud); ++i)
    ASSERT_LT((Position(valueOf(mesh.cloud, i, "x"),
                        valueOf(mesh.cloud, i, "y"),
                        valueOf(mesh.cloud, i, "z")) -
               test::MAP_PLACE)
                  .norm(),
              15.0);
}

} // namespace
} // namespace app_test
