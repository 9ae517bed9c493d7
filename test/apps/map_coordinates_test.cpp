// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: coordinates of more digits than floats have.
#include <pcl/surface_ccaa/global_shift.h>

#include "io/model_io.h"
#include "io/point_columns.h"
#include "mesh/cloud_access.h"
#include "repair_fixture.h"
#include "support/clouds.h"

namespace app_test {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Positions;

Positions
positionsIn(const pcl::PCLPointCloud2& cloud)
{
  return pcl::ccaa::copyPositions(pcl::ccaa::positionView(cloud)).positions;
}

/** A wavy surface around the origin, exact also far away. */
Positions
wavySurface()
{
  return test::onGrid(
      test::shifted(test::scaled(test::terrainCloud(24), 0.25), Position(-3, -3, 0)));
}

/** The same with a hole, as a mesh at a place, all of it in doubles. */
pcl::PolygonMesh
wavyMesh(const Position& place)
{
  test::Shape shape = test::terrain(24, 24);
  shape = test::withoutTriangles(shape, {500, 501, 502, 503, 550, 551, 552, 553});
  pcl::PolygonMesh mesh = test::toPolygonMesh(shape);
  mesh.cloud = test::toDoubleCloud(test::shifted(
      test::onGrid(test::shifted(shape.vertices, Position(-12, -12, 0))), place));
  return mesh;
}

/** With the shift as it will be found, so that nothing is rounded. */
const Position PLACE(596650, 5420310, 250);

class MapCoordinates : public RepairApp {
protected:
  /** Run a program; \return what it has written to out.ply. */
  app::Model
  outputOf(const std::string& program, const std::vector<std::string>& arguments)
  {
    const RunResult result =
        runApp(program,
               arguments,
               {folder_.path("out.ply"), "--report", folder_.path("report.json")});
    EXPECT_EQ(0, result.exit_code) << result.errors;
    messages_ = result.errors;
    return loadMesh(folder_.path("out.ply"));
  }

  app::Model
  reconstructed(const Position& place, const std::string& ending = ".ply")
  {
    const std::string path = folder_.path("in" + ending);
    save(path, test::toDoubleCloud(test::shifted(wavySurface(), place)));
    return outputOf("pcl_ccaa_reconstruct", {path, "--repair"});
  }

  app::Model
  repairedAt(const Position& place, std::vector<std::string> arguments = {})
  {
    arguments.push_back(folder_.path("mesh.ply"));
    save(arguments.back(), wavyMesh(place));
    return outputOf("pcl_repair_holes", arguments);
  }

  std::string messages_;
};

TEST_F(MapCoordinates, AreReconstructedToTheSameTriangles)
{
  const app::Model near = reconstructed(Position::Zero());
  const app::Model far = reconstructed(PLACE);
  EXPECT_FALSE(near.mesh.polygons.empty());
  expectSamePolygons(near.mesh, far.mesh);
}

TEST_F(MapCoordinates, ComeBackBitForBitFromAReconstruction)
{
  const Positions given = test::shifted(wavySurface(), PLACE);
  Positions positions = positionsIn(reconstructed(PLACE).mesh.cloud);
  ASSERT_GE(positions.size(), given.size());
  positions.resize(given.size());
  EXPECT_EQ(given, positions);
}

TEST_F(MapCoordinates, InTextAreReconstructedAsThoseInBinaryFiles)
{
  const app::Model binary = reconstructed(PLACE);
  const app::Model text = reconstructed(PLACE, ".xyz");
  expectSamePolygons(binary.mesh, text.mesh);
  EXPECT_EQ(positionsIn(binary.mesh.cloud), positionsIn(text.mesh.cloud));
}

TEST_F(MapCoordinates, AreRepairedToTheSameSurface)
{
  const app::Model near = repairedAt(Position::Zero());
  const app::Model far = repairedAt(PLACE);
  EXPECT_GT(near.mesh.polygons.size(), wavyMesh(PLACE).polygons.size());
  expectSamePolygons(near.mesh, far.mesh);
  const Positions here = positionsIn(near.mesh.cloud);
  const Positions there = positionsIn(far.mesh.cloud);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i)
    EXPECT_LT((there[i] - here[i] - PLACE).norm(), 1e-6);
}

TEST_F(MapCoordinates, NeedNoFrameOfTheirOwnForFreePoints)
{
  const Positions samples{{0.5, 0.5, 0}, {1, 1, 0}, {-1, 0, 0}};
  save(folder_.path("free.ply"), test::toDoubleCloud(samples));
  const app::Model near =
      repairedAt(Position::Zero(), {"--free-points", folder_.path("free.ply")});
  save(folder_.path("free.ply"), test::toDoubleCloud(test::shifted(samples, PLACE)));
  const app::Model far = repairedAt(PLACE, {"--free-points", folder_.path("free.ply")});
  expectSamePolygons(near.mesh, far.mesh);
}

TEST_F(MapCoordinates, HaveTheirShiftToldInNotesAndReports)
{
  reconstructed(PLACE);
  EXPECT_EQ(nlohmann::json({596650.0, 5420310.0, 250.0}), report().at("global_shift"));
  EXPECT_NE(std::string::npos, messages_.find("596650,5420310,250")) << messages_;
  reconstructed(Position::Zero());
  EXPECT_EQ(nlohmann::json({0.0, 0.0, 0.0}), report().at("global_shift"));
  EXPECT_EQ(std::string::npos, messages_.find("shift")) << messages_;
}

TEST_F(MapCoordinates, AreMergedWithOneShift)
{
  const Positions all = test::shifted(wavySurface(), PLACE);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 3);
  save(folder_.path("a.ply"), test::toDoubleCloud({all.begin(), middle}));
  save(folder_.path("b.xyz"), test::toDoubleCloud({middle, all.end()}));
  const app::Model whole = reconstructed(PLACE);
  const app::Model merged = outputOf(
      "pcl_ccaa_reconstruct",
      {folder_.path("a.ply"), folder_.path("b.xyz"), "--merge", "--repair", "-o"});
  expectSamePolygons(whole.mesh, merged.mesh);
  EXPECT_EQ(positionsIn(whole.mesh.cloud), positionsIn(merged.mesh.cloud));
}

TEST_F(MapCoordinates, AreMergedAsDoublesWhereOneFileHasFloats)
{
  const Positions given = wavySurface();
  save(folder_.path("a.ply"), test::toDoubleCloud({{0.1, 0, 9}}));
  save(folder_.path("b.ply"), test::toRawCloud(given));
  Positions positions = positionsIn(
      outputOf("pcl_ccaa_reconstruct",
               {folder_.path("a.ply"), folder_.path("b.ply"), "--merge", "-o"})
          .mesh.cloud);
  EXPECT_EQ(Position(0.1, 0, 9), positions.front());
  positions.erase(positions.begin());
  EXPECT_EQ(given, positions);
}

TEST_F(MapCoordinates, TakeTheSensorWithThem)
{
  const Position sensors[] = {PLACE + Position(0.125, 0, 40),
                              PLACE - Position(0, 0, 40)};
  std::vector<pcl::Vertices> polygons[2];
  for (int side = 0; side < 2; ++side) {
    app::FileExtras extras;
    extras.viewpoint.position = sensors[side];
    extras.viewpoint.known = true;
    app::OutputFile file;
    ASSERT_TRUE(file.open(folder_.path("in.pcd")).ok());
    app::writeCloud(app::Target(folder_.path("in.pcd")),
                    test::toDoubleCloud(test::shifted(wavySurface(), PLACE)),
                    extras,
                    file);
    ASSERT_TRUE(file.commit().ok());
    const app::Model model =
        outputOf("pcl_ccaa_reconstruct", {folder_.path("in.pcd"), "--repair"});
    EXPECT_EQ(sensors[side], model.viewpoint.position);
    polygons[side] = model.mesh.polygons;
  }
  EXPECT_NE(test::toTriangles(polygons[0]), test::toTriangles(polygons[1]));
}

TEST_F(MapCoordinates, HaveTheSameFacts)
{
  const auto factsAt = [&](const Position& place) {
    save(folder_.path("mesh.ply"), wavyMesh(place));
    const RunResult result = runApp(
        "pcl_mesh_quality", {folder_.path("mesh.ply"), "--report", "-", "--quiet"});
    auto facts = nlohmann::json::parse(result.output);
    for (const char* key : {"seconds", "warnings", "global_shift"})
      facts.erase(key);
    return facts;
  };
  EXPECT_EQ(factsAt(Position::Zero()), factsAt(PLACE));
}

TEST_F(MapCoordinates, NameRegionsOfDamage)
{
  save(folder_.path("mesh.ply"), wavyMesh(PLACE));
  const app::Model left = outputOf(
      "pcl_damage_cloud",
      {folder_.path("mesh.ply"), "--absolute", "--sphere", "596650,5420310,250,3"});
  const std::size_t all = app::pointCount(wavyMesh(PLACE).cloud);
  EXPECT_LT(app::pointCount(left.mesh.cloud), all);
  EXPECT_GT(app::pointCount(left.mesh.cloud), all / 2);
  for (const Position& position : positionsIn(left.mesh.cloud))
    EXPECT_GE((position - PLACE).norm(), 3.0);
}

TEST_F(MapCoordinates, AreDrawnAsNearTheOrigin)
{
  const auto pictureAt = [&](const Position& place) {
    save(folder_.path("mesh.ply"), wavyMesh(place));
    const RunResult result =
        runApp("pcl_render_mesh",
               {folder_.path("mesh.ply"),
                folder_.path("mesh.png"),
                "--size",
                "200x150",
                "--focus",
                std::to_string(place.x() + 1) + "," + std::to_string(place.y()) + "," +
                    std::to_string(place.z())});
    EXPECT_EQ(0, result.exit_code) << result.errors;
    return readFile(folder_.path("mesh.png"));
  };
  EXPECT_TRUE(pictureAt(Position::Zero()) == pictureAt(PLACE));
}

TEST_F(MapCoordinates, AreInspectedNearTheOrigin)
{
  const auto loopsAt = [&](const Position& place) {
    save(folder_.path("mesh.ply"), wavyMesh(place));
    EXPECT_EQ(0, inspectQuickly("mesh.ply").exit_code);
    return readFile(foundFile("loops.vtk"));
  };
  const std::string near = loopsAt(Position::Zero());
  EXPECT_EQ(near, loopsAt(PLACE));
  EXPECT_NE(std::string::npos, readFile(foundFile("legend.txt")).find("596650"));
}

/** Two caps of a sphere of radius 1, whose bridges are written to bridges.vtk. */
void
saveCapsAt(const Position& place, const std::string& path)
{
  pcl::PolygonMesh mesh = twoCaps();
  mesh.cloud = test::toDoubleCloud(test::shifted(positionsIn(mesh.cloud), place));
  save(path, mesh);
}

TEST_F(MapCoordinates, HaveTheirBridgesWrittenThere)
{
  saveCapsAt(PLACE, folder_.path("caps.ply"));
  outputOf("pcl_repair_holes",
           {folder_.path("caps.ply"), "--bridges", folder_.path("bridges.vtk")});
  const app::Model bridges = loadCloud(folder_.path("bridges.vtk"));
  for (const Position& position : positionsIn(bridges.mesh.cloud))
    EXPECT_LT((position - PLACE).norm(), 2.0);
}

TEST_F(MapCoordinates, AreThoseOfPlacesInTheReportOfAnInspection)
{
  saveCapsAt(PLACE, folder_.path("caps.ply"));
  EXPECT_EQ(
      0,
      inspectQuickly("caps.ply", {"--report", folder_.path("report.json")}).exit_code);
  const nlohmann::json lines = report().at("lines");
  ASSERT_FALSE(lines.empty());
  for (const nlohmann::json& line : lines) {
    const std::vector<double> place = line.at("origin").at("position");
    EXPECT_LT((Position(place[0], place[1], place[2]) - PLACE).norm(), 2.0);
  }
}

TEST_F(MapCoordinates, GetNoiseAtTheirPlace)
{
  save(folder_.path("mesh.ply"), wavyMesh(PLACE));
  const Positions noisy = positionsIn(outputOf("pcl_damage_cloud",
                                               {folder_.path("mesh.ply"),
                                                "--sphere",
                                                "0.5,0.5,0.5,0.1",
                                                "--keep",
                                                "1",
                                                "--noise",
                                                "0.1"})
                                          .mesh.cloud);
  const Positions given = positionsIn(wavyMesh(PLACE).cloud);
  ASSERT_EQ(given.size(), noisy.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_LT((noisy[i] - given[i]).norm(), 1.0);
    moved += noisy[i] != given[i] ? 1 : 0;
  }
  EXPECT_GT(moved, 0U);
  EXPECT_LT(moved, given.size() / 4);
}

TEST_F(MapCoordinates, AreRefusedForStl)
{
  save(folder_.path("mesh.ply"), wavyMesh(PLACE));
  const RunResult result =
      runApp("pcl_repair_holes", {folder_.path("mesh.ply"), folder_.path("out.stl")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("single precision")) << result.errors;
  EXPECT_EQ(1U, folder_.names().size());
}

TEST_F(MapCoordinates, InFloatsHaveTheirLostDigitsTold)
{
  save(folder_.path("in.ply"), test::toRawCloud(test::shifted(wavySurface(), PLACE)));
  const RunResult result =
      runApp("pcl_ccaa_reconstruct", {folder_.path("in.ply"), "--dry-run"});
  EXPECT_NE(std::string::npos, result.errors.find("steps by 0.5")) << result.errors;
  EXPECT_NE(std::string::npos, result.errors.find("0 decimals")) << result.errors;
}

TEST_F(MapCoordinates, OfFreePointsInFloatsHaveTheirLostDigitsTold)
{
  save(folder_.path("free.ply"), test::toRawCloud(test::shifted(wavySurface(), PLACE)));
  repairedAt(PLACE, {"--free-points", folder_.path("free.ply")});
  EXPECT_NE(std::string::npos, messages_.find("free points: ")) << messages_;
}

TEST_F(MapCoordinates, BeyondAllFloatsAreRefused)
{
  save(folder_.path("in.ply"), test::toDoubleCloud({{0, 0, 0}, {1e200, 0, 0}}));
  app::Model model;
  EXPECT_FALSE(app::readCloud(folder_.path("in.ply"), model).ok());
}

TEST_F(MapCoordinates, ThatAreSmallDoublesStayDoubles)
{
  const Positions given = test::bumpySphere(300);
  save(folder_.path("in.ply"), test::toDoubleCloud(given));
  const app::Model model = outputOf("pcl_ccaa_reconstruct", {folder_.path("in.ply")});
  EXPECT_EQ(given, positionsIn(model.mesh.cloud));
  save(folder_.path("in.ply"), test::toRawCloud(given));
  const app::Model single = outputOf("pcl_ccaa_reconstruct", {folder_.path("in.ply")});
  expectSamePolygons(single.mesh, model.mesh);
}

} // namespace
} // namespace app_test
