// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: scans that overlap and disagree become one even layer.
#include "clean/clean_cloud.h"
#include "clean/two_sheets.h"
#include "io/point_columns.h"
#include "mesh/cloud_access.h"
#include "model_samples.h"
#include "reconstruct_fixture.h"
#include "support/clouds.h"
#include "support/random_source.h"
#include "support/raw_clouds.h"
#include "support/shared_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app_test {
namespace {

using pcl::ccaa::Position;

constexpr double SPACING = 0.05; // of one scan of the unit sphere
const Position SENSORS[] = {
    {4, 0, 0}, {-4, 0, 0}, {0, 4, 0}, {0, -4, 0}, {0, 0, 4}, {0, 0, -4}};

/** Six scans of a sphere, each from its side, with noise and moved a little; fields:
 * vp, intensity = x, scan, and an orange that is the same everywhere. */
app::Model
scannedSphere(double noise, double outliers = 0.0)
{
  pcl::ccaa::test::RandomSource random(11);
  std::vector<std::pair<Position, int>> points;
  for (int scan = 0; scan < 6; ++scan) {
    const Position shift = 0.3 * noise * SPACING *
                           Position(random.normal(), random.normal(), random.normal());
    for (int i = 0; i < 5000; ++i) {
      const Position at =
          Position(random.normal(), random.normal(), random.normal()).normalized();
      if (at.dot(SENSORS[scan]) > 1.0)
        points.emplace_back(at * (1 + noise * SPACING * random.normal()) + shift, scan);
    }
  }
  for (auto left = static_cast<std::size_t>(outliers * double(points.size())); left > 0;
       --left)
    points.emplace_back(
        Position(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)),
        0);
  test::FieldList fields = test::xyzFields();
  for (const char* name : {"vp_x", "vp_y", "vp_z", "intensity", "rgb"})
    fields.emplace_back(name, pcl::PCLPointField::FLOAT32);
  fields.emplace_back("scan", pcl::PCLPointField::INT32);
  app::Model model;
  model.mesh.cloud = test::rawCloud(fields, points.size());
  const char* const axes[] = {"x", "y", "z"};
  const char* const places[] = {"vp_x", "vp_y", "vp_z"};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [at, scan] = points[i];
    for (int axis = 0; axis < 3; ++axis) {
      test::setValue(model.mesh.cloud, i, axes[axis], float(at[axis]));
      test::setValue(model.mesh.cloud, i, places[axis], float(SENSORS[scan][axis]));
    }
    test::setValue(model.mesh.cloud, i, "intensity", float(at.x()));
    test::setValue(model.mesh.cloud, i, "rgb", std::uint32_t{0xffa040});
    test::setValue(model.mesh.cloud, i, "scan", scan);
  }
  return model;
}

app::CleanReport
clean(app::Model& model,
      const app::CleanParameters& parameters = {},
      unsigned threads = 2)
{
  return app::cleanCloud(
      parameters, threads, [](double) { return true; }, model);
}

/** Root mean square distance from the unit sphere. */
double
deviation(const app::Model& model)
{
  double sum = 0;
  const auto points = app::readPositions(model.mesh.cloud);
  for (const Eigen::Vector3f& point : points)
    sum += std::pow(double{point.norm()} - 1.0, 2);
  return std::sqrt(sum / double(points.size()));
}

TEST(CleanCloud, TakesMostOfTheNoiseAway)
{
  for (const double noise : {0.1, 0.3, 1.0, 2.0}) {
    app::Model model = scannedSphere(noise);
    const double before = deviation(model);
    clean(model);
    EXPECT_LT(deviation(model), 0.5 * before) << noise;
  }
}

TEST(CleanCloud, LeavesExactPointsOnTheirSurface)
{
  app::Model model = scannedSphere(0.0);
  clean(model);
  EXPECT_LT(deviation(model), 0.01 * SPACING);
}

TEST(CleanCloud, KeepsTheSpacingBetweenPoints)
{
  for (const double spacing : {0.0, 0.08}) {
    app::Model model = scannedSphere(0.3);
    app::CleanParameters parameters;
    parameters.spacing = spacing;
    const app::CleanReport report = clean(model, parameters);
    const auto points = app::readPositions(model.mesh.cloud);
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, (points[i] - points[j]).norm());
    EXPECT_GE(double{nearest}, report.spacing * (1 - 1e-5));
    EXPECT_TRUE(spacing == 0 || spacing == report.spacing);
  }
}

TEST(CleanCloud, LeavesNoWidePlaceWithoutAPoint)
{
  app::Model model = scannedSphere(0.3);
  const auto before = app::readPositions(model.mesh.cloud);
  const app::CleanReport report = clean(model);
  const auto after = app::readPositions(model.mesh.cloud);
  for (std::size_t i = 0; i < before.size(); i += 50) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& point : after)
      nearest = std::min(nearest, (point - before[i]).norm());
    EXPECT_LT(double{nearest}, report.radius) << i;
  }
}

TEST(CleanCloud, TakesOutliersAway)
{
  const auto far = [](const app::Model& model) {
    std::size_t count = 0;
    for (const Eigen::Vector3f& point : app::readPositions(model.mesh.cloud))
      count += std::abs(point.norm() - 1.0F) > 0.5F ? 1 : 0;
    return count;
  };
  app::Model model = scannedSphere(0.1, 0.01);
  const std::size_t before = far(model);
  EXPECT_GT(clean(model).outliers, 0U);
  EXPECT_LE(10 * far(model), before); // the scene is another one for each compiler
}

TEST(CleanCloud, GivesEachPointASensorThatStoodThereAndSawIt)
{
  app::Model model = scannedSphere(0.3);
  clean(model);
  const auto points = app::readPositions(model.mesh.cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Position sensor(valueOf(model.mesh.cloud, i, "vp_x"),
                          valueOf(model.mesh.cloud, i, "vp_y"),
                          valueOf(model.mesh.cloud, i, "vp_z"));
    EXPECT_NE(std::end(SENSORS),
              std::find(std::begin(SENSORS), std::end(SENSORS), sensor));
    EXPECT_GT(points[i].cast<double>().dot(sensor), 0.5);
    const double scan = valueOf(model.mesh.cloud, i, "scan");
    EXPECT_EQ(sensor, SENSORS[static_cast<std::size_t>(scan)]);
  }
}

TEST(CleanCloud, MixesColoursAndNumbersOfPlacesNearby)
{
  app::Model model = scannedSphere(0.1);
  const app::CleanReport report = clean(model);
  const auto points = app::readPositions(model.mesh.cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(0xffa040U,
              test::valueOf<std::uint32_t>(model.mesh.cloud, i, "rgb") & 0xffffffU);
    EXPECT_NEAR(
        points[i].x(), valueOf(model.mesh.cloud, i, "intensity"), report.radius);
  }
}

TEST(CleanCloud, LeavesOutPointsThatAreNotFinite)
{
  app::Model model = scannedSphere(0.1);
  for (const unsigned int i : {0U, 77U, 1234U})
    test::setValue(model.mesh.cloud, i, "y", std::numeric_limits<float>::quiet_NaN());
  model.mesh.cloud.is_dense = false;
  EXPECT_EQ(3U, clean(model).skipped_points);
  EXPECT_TRUE(model.mesh.cloud.is_dense);
  for (const Eigen::Vector3f& point : app::readPositions(model.mesh.cloud))
    EXPECT_TRUE(point.allFinite());
}

TEST(CleanCloud, IsTheSameForAnyNumberOfThreads)
{
  app::Model one = scannedSphere(0.3);
  app::Model two = one;
  clean(one, {}, 1);
  clean(two, {}, 3);
  EXPECT_EQ(one.mesh.cloud.data, two.mesh.cloud.data);
}

TEST(CleanCloud, LeavesTooFewPointsAsTheyAre)
{
  for (const int points : {0, 1, 2, 20}) {
    app::Model model;
    model.mesh.cloud = test::toRawCloud(test::lineCloud(points));
    const auto before = model.mesh.cloud.data;
    EXPECT_EQ(0U, clean(model).output_points);
    EXPECT_EQ(before, model.mesh.cloud.data);
  }
}

TEST(CleanCloud, StandsPointsThatAreAllOneOrOnALine)
{
  for (const auto& points :
       {test::withDuplicates(test::lineCloud(3), 40), test::lineCloud(500)}) {
    app::Model model;
    model.mesh.cloud = test::toRawCloud(points);
    clean(model);
    EXPECT_GT(app::pointCount(model.mesh.cloud), 0U);
  }
}

TEST(CleanCloud, StopsWhenToldAndChangesNothingThen)
{
  app::Model model = scannedSphere(0.3);
  const auto before = model.mesh.cloud.data;
  const auto report = app::cleanCloud(
      {}, 1, [](double share) { return share < 0.5; }, model);
  EXPECT_EQ(0U, report.output_points);
  EXPECT_EQ(before, model.mesh.cloud.data);
}

TEST(CleanCloud, KeepsMapCoordinates)
{
  app::Model model;
  model.mesh.cloud = test::toDoubleCloud(
      test::shifted(test::noisySphere(4000, 0.01), test::MAP_PLACE));
  model.shift = pcl::GlobalShift::of(model.mesh.cloud);
  clean(model);
  const auto view = pcl::ccaa::positionView(model.mesh.cloud);
  for (std::size_t i = 0; i < view.size(); ++i)
    EXPECT_NEAR(1.0, (view[i] - test::MAP_PLACE).norm(), 0.03);
}

TEST(CleanCloud, DoesNotJoinTheSidesOfAThinWall)
{
  const double spacing = 1.0 / 60;
  for (const double thickness : {4.0 * spacing, 6.0 * spacing}) {
    app::Model model;
    model.mesh.cloud = test::toRawCloud(
        test::withNoise(test::thinPlateCloud(60, thickness), 0.1 * spacing));
    clean(model);
    std::size_t between = 0;
    for (const Eigen::Vector3f& point : app::readPositions(model.mesh.cloud))
      between += point.z() > 0.3 * thickness && point.z() < 0.7 * thickness ? 1 : 0;
    EXPECT_LT(100 * between, app::pointCount(model.mesh.cloud)) << thickness;
  }
}

TEST(TwoSheets, AreNotFoundInNoiseCapsAndEdges)
{
  for (const auto& points : {test::noisySphere(3000, 0.05),
                             test::fibonacciSphere(3000),
                             test::withNoise(test::cubeCloud(20), 0.02)}) {
    const auto found = app::findTwoSheets(test::toCloud(points), 0.3, 0.0, 2);
    EXPECT_LT(std::count(found.begin(), found.end(), 1), 60);
  }
}

/** A PCD for each sensor. */
std::vector<std::string>
saveScans(const TemporaryFolder& folder, double noise)
{
  std::vector<std::string> names;
  for (int scan = 0; scan < 6; ++scan) {
    app::Model model = scannedSphere(noise);
    pcl::ccaa::Positions points;
    for (std::size_t i = 0; i < app::pointCount(model.mesh.cloud); ++i)
      if (valueOf(model.mesh.cloud, i, "scan") == scan)
        points.push_back(pcl::ccaa::positionView(model.mesh.cloud)[i]);
    const auto& at = SENSORS[scan];
    names.push_back(folder.path("scan" + std::to_string(scan) + ".pcd"));
    std::string text = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " +
                       std::to_string(points.size()) + "\nHEIGHT 1\nVIEWPOINT " +
                       std::to_string(at.x()) + " " + std::to_string(at.y()) + " " +
                       std::to_string(at.z()) + " 1 0 0 0\nDATA ascii\n";
    for (const auto& point : points)
      text += std::to_string(point.x()) + " " + std::to_string(point.y()) + " " +
              std::to_string(point.z()) + "\n";
    writeFile(names.back(), text);
  }
  return names;
}

TEST_F(ReconstructApp, MergesAndCleansScansToAWholeSphere)
{
  std::vector<std::string> arguments = saveScans(folder_, 0.5);
  for (const std::string& argument : {std::string("--merge"),
                                      std::string("--clean"),
                                      std::string("-o"),
                                      folder_.path("mesh.ply"),
                                      std::string("--report"),
                                      folder_.path("report.json")})
    arguments.push_back(argument);
  const RunResult result = runApp("pcl_ccaa_reconstruct", arguments);
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_NE(std::string::npos, result.output.find("cleaning: ")) << result.output;
  EXPECT_TRUE(report().at("watertight")) << result.output;
  EXPECT_EQ(0, report().at("genus"));
  EXPECT_EQ("sensor position", report().at("outer_side_by"));
  const nlohmann::json cleaning = report().at("cleaning");
  EXPECT_EQ(report().at("N"), cleaning.at("output_points"));
  EXPECT_LT(cleaning.at("output_points"), cleaning.at("grid_points"));
}

TEST_F(ReconstructApp, CleansTheScansOfTheBunny)
{
  const std::string scans = test::sharedData("bunny_scans/bunny_scans_registered.ply");
  SKIP_WITHOUT_DATA(scans);
  const RunResult result = runApp("pcl_ccaa_reconstruct",
                                  {scans,
                                   "--clean",
                                   "-o",
                                   folder_.path("mesh.ply"),
                                   "--report",
                                   folder_.path("report.json")});
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_EQ(0, report().at("genus"));
  EXPECT_EQ(1, report().at("pieces"));
  EXPECT_LT(report().at("boundary_loops"), 12); // 533 as they are
}

TEST_F(ReconstructApp, RefusesParametersOfCleaningWithoutIt)
{
  save(folder_.path("a.pcd"), colouredCloud(300, 1));
  const RunResult result = reconstruct("a.pcd", "mesh.ply", {"--clean-radius", "0.1"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("--clean-radius needs --clean"));
}

} // namespace
} // namespace app_test
