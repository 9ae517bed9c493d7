// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what user and file tell about the outer side, through the
// programs.
#include "io/model_io.h"
#include "io/output_file.h"
#include "mesh/cloud_access.h"
#include "repair_fixture.h"
#include "support/clouds.h"
#include "support/single_view.h"

namespace app_test {
namespace {

constexpr std::size_t RAYS = 60;
constexpr double LEAST_SHARE = 0.97;

/** Programs on scenes from one side. */
class Sides : public RepairApp {
protected:
  /** A cloud as PCD, whose VIEWPOINT is the place. */
  std::string
  write(const std::string& name,
        const pcl::ccaa::Positions& points,
        const Eigen::Vector3d& place)
  {
    app::FileExtras extras;
    extras.viewpoint.position = place;
    app::OutputFile file;
    EXPECT_TRUE(file.open(folder_.path(name)).ok());
    app::writeCloud(folder_.path(name), test::toRawCloud(points), extras, file);
    EXPECT_TRUE(file.commit().ok());
    return folder_.path(name);
  }

  /** \return what told the outer side, after a run that wrote "out.ply" */
  std::string
  reconstruct(const std::string& input, std::vector<std::string> options = {})
  {
    options.insert(options.begin(), {input, folder_.path("out.ply")});
    options.insert(options.end(), {"--report", folder_.path("report.json")});
    const RunResult result = runApp("pcl_ccaa_reconstruct", options);
    EXPECT_NE(1, result.exit_code) << result.errors;
    return report().at("outer_side_by");
  }

  double
  facingShareOf(const std::string& name, const Eigen::Vector3d& place) const
  {
    const app::Model model = loadMesh(folder_.path(name));
    const auto points =
        pcl::ccaa::copyPositions(pcl::ccaa::positionView(model.mesh.cloud));
    return test::facingShare(model.mesh.polygons, points.positions, place);
  }
};

TEST_F(Sides, AViewpointOfThePcdLastsToTheEnd)
{
  const test::SingleView view = test::singleView(1, RAYS);
  const std::string told = reconstruct(write("a.pcd", view.points, view.sensor));
  EXPECT_EQ(0U, told.find("sensor position")) << told;
  EXPECT_GE(facingShareOf("out.ply", view.sensor), LEAST_SHARE);
}

TEST_F(Sides, AViewpointOnTheCommandLineIsFollowedAndHandedOn)
{
  const test::SingleView view = test::singleView(2, RAYS);
  char place[96];
  std::snprintf(place,
                sizeof(place),
                "%.9g,%.9g,%.9g",
                view.sensor.x(),
                view.sensor.y(),
                view.sensor.z());
  const std::string input = write("a.pcd", view.points, Eigen::Vector3d(-90, 7, 40));
  const std::string told = reconstruct(input, {"--viewpoint", place});
  EXPECT_EQ(0U, told.find("the viewpoint told")) << told;
  EXPECT_GE(facingShareOf("out.ply", view.sensor), LEAST_SHARE);
  const app::Model model = loadMesh(folder_.path("out.ply"));
  EXPECT_TRUE(model.viewpoint.position.isApprox(view.sensor, 1e-6));
}

TEST_F(Sides, AViewpointOfZeroIsTheOriginOfTheSensorsFrameAndIsHandedOn)
{
  const test::SingleView view = test::inSensorFrame(test::singleView(3, RAYS));
  EXPECT_EQ("the origin taken as sensor position",
            reconstruct(write("a.pcd", view.points, view.sensor)));
  EXPECT_GE(facingShareOf("out.ply", view.sensor), LEAST_SHARE);
  const RunResult looked = runApp(
      "pcl_repair_holes",
      {folder_.path("out.ply"), "--dry-run", "--report", folder_.path("report.json")});
  EXPECT_NE(1, looked.exit_code) << looked.errors;
  EXPECT_EQ("the origin taken as sensor position",
            report().at("islands").at(0).at("rule"));
}

TEST_F(Sides, ATerrainLooksWhereUpIs)
{
  const std::string input =
      write("a.pcd", test::terrainCloud(20), Eigen::Vector3d::Zero());
  EXPECT_EQ("the up direction told", reconstruct(input, {"--up", "0,0,-1"}));
  EXPECT_EQ(0.0, facingShareOf("out.ply", {10.0, 10.0, 1e6}));
}

TEST_F(Sides, AGuessIsNamedInTheSummaryAndKeptByTheRepair)
{
  const std::string input =
      write("a.pcd", test::terrainCloud(20), Eigen::Vector3d::Zero());
  EXPECT_EQ("guessed: up (+z) from the dominant plane", reconstruct(input));
  const RunResult result =
      runApp("pcl_ccaa_reconstruct", {input, folder_.path("whole.ply"), "--repair"});
  EXPECT_NE(std::string::npos,
            result.output.find("guessed: up (+z) from the dominant plane"));
  EXPECT_EQ(1.0, facingShareOf("whole.ply", {10.0, 10.0, 1e6}));
}

TEST_F(Sides, PlacesThatAreNoneAreRefused)
{
  const std::string input =
      write("a.pcd", test::terrainCloud(5), Eigen::Vector3d::Zero());
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--viewpoint", "1,2"},
        {"--viewpoint", "1,2,inf"},
        {"--up", "0,0,0"}}) {
    const RunResult result =
        runApp("pcl_ccaa_reconstruct", {input, folder_.path("out.ply")}, options);
    EXPECT_EQ(1, result.exit_code) << options[1];
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  }
}

} // namespace
} // namespace app_test
