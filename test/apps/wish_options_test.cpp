// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what users want closed and joined, as options.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "repair_fixture.h"
#include "support/repair_shapes.h"

#include <cmath>

namespace app_test {
namespace {

using pcl::ccaa::Position;
using test::Shape;

/** A box of 1 x 1 x 3 without its bottom. */
Shape
openTower()
{
  Shape shape = test::cube(12);
  for (Position& p : shape.vertices)
    p.z() *= 3.0;
  return test::inPieces(shape, [](const Position& p) { return p.z() < 1e-9 ? -1 : 0; });
}

/** Upper half of a sphere: a border to be left open. */
Shape
dome()
{
  return test::inPieces(test::icosphere(4),
                        [](const Position& p) { return p.z() < 0.3 ? -1 : 0; });
}

class WishOptions : public RepairApp {
protected:
  RunResult
  repair(const std::string& input, const std::vector<std::string>& options)
  {
    return runApp(
        "pcl_repair_holes", {folder_.path(input), folder_.path("out.ply")}, options);
  }

  RunResult
  dryRun(const std::string& input, const std::vector<std::string>& options)
  {
    return runApp("pcl_repair_holes", {folder_.path(input), "--dry-run"}, options);
  }

  void
  save(const std::string& name, const Shape& shape) const
  {
    app_test::save(folder_.path(name), test::toPolygonMesh(shape));
  }

  test::Topology
  topologyOfOutput() const
  {
    return test::topologyOf(
        test::toTriangles(loadMesh(folder_.path("out.ply")).mesh.polygons));
  }

  nlohmann::json
  decisions() const
  {
    return nlohmann::json::parse(readFile(folder_.path("decisions.json")));
  }

  void
  write(const nlohmann::json& decisions) const
  {
    writeFile(folder_.path("decisions.json"), decisions.dump());
  }

  std::vector<std::string>
  withDecisions() const
  {
    return {"--decisions", folder_.path("decisions.json")};
  }
};

TEST_F(WishOptions, AnOuterBorderStaysOpenWithExitCodeZero)
{
  save("dome.ply", dome());
  EXPECT_EQ(0, repair("dome.ply", {}).exit_code);
  EXPECT_EQ(1U, topologyOfOutput().borders);
}

TEST_F(WishOptions, CloseAllClosesAnOuterBorder)
{
  save("dome.ply", dome());
  EXPECT_EQ(0, repair("dome.ply", {"--close", "all"}).exit_code);
  EXPECT_EQ(0U, topologyOfOutput().borders);
}

TEST_F(WishOptions, CloseNoneLeavesAHoleOpenWithExitCodeZero)
{
  save("tower.ply", openTower());
  EXPECT_EQ(0, repair("tower.ply", {"--close", "none"}).exit_code);
  EXPECT_EQ(1U, topologyOfOutput().borders);
}

TEST_F(WishOptions, OwnLimitsAreNoShortfall)
{
  save("tower.ply", openTower());
  for (const auto& [name, value] :
       {std::pair<const char*, const char*>{"--greatest-hole", "5"},
        {"--greatest-hole-length", "1"},
        {"--greatest-hole-length", "20%"}}) {
    EXPECT_EQ(0, repair("tower.ply", {name, value}).exit_code) << name;
    EXPECT_EQ(1U, topologyOfOutput().borders) << name << value;
  }
}

TEST_F(WishOptions, IslandsThatWereNotToBeJoinedAreNoShortfall)
{
  app_test::save(folder_.path("caps.ply"), twoCaps());
  EXPECT_EQ(0, repair("caps.ply", {"--no-join"}).exit_code);
  EXPECT_EQ(2U, topologyOfOutput().components);
  EXPECT_EQ(0, repair("caps.ply", {"--greatest-bridge", "5%"}).exit_code);
  EXPECT_EQ(2U, topologyOfOutput().components);
}

TEST_F(WishOptions, WatertightEndsWithTwoAndAListWhereSomethingStaysOpen)
{
  save("band.ply", test::moebiusBand(40)); // nothing closes what has no two sides
  const RunResult result = repair("band.ply", {"--watertight"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("1 boundary loop is left open"))
      << result.errors;
}

TEST_F(WishOptions, WatertightClosesWhatCanBeClosed)
{
  save("dome.ply", dome());
  EXPECT_EQ(0, repair("dome.ply", {"--watertight"}).exit_code);
  EXPECT_EQ(0U, topologyOfOutput().borders);
}

TEST_F(WishOptions, SmallIslandsAreDroppedByTrianglesAndByArea)
{
  const Shape ball = test::icosphere(3);
  save("balls.ply",
       test::joined(ball, test::translated(test::scaled(ball, 0.02), {5.0, 0.0, 0.0})));
  for (const char* limit : {"0.5%", "0.1u2"}) {
    ASSERT_EQ(0, repair("balls.ply", {"--drop-islands", limit}).exit_code) << limit;
    EXPECT_EQ(1U, topologyOfOutput().components) << limit;
  }
  for (const char* limit : {"1280", "0.01%"}) {
    ASSERT_EQ(0, repair("balls.ply", {"--drop-islands", limit}).exit_code) << limit;
    EXPECT_EQ(2U, topologyOfOutput().components) << limit;
  }
  EXPECT_EQ(1, repair("balls.ply", {"--drop-islands", "1281"}).exit_code);
}

TEST_F(WishOptions, TheCapOfATowerIsFlatUnlessItIsToBeSmooth)
{
  save("tower.ply", openTower());
  const auto lowest = [&] {
    double height = 1e30;
    for (const auto& p :
         app::readPositions(loadMesh(folder_.path("out.ply")).mesh.cloud))
      height = std::min(height, static_cast<double>(p.z()));
    return height;
  };
  ASSERT_EQ(0, repair("tower.ply", {}).exit_code);
  EXPECT_GE(lowest(), 0.25 - 1e-6);
  ASSERT_EQ(0, repair("tower.ply", {"--cap", "smooth"}).exit_code);
  EXPECT_LT(lowest(), 0.2);
}

TEST_F(WishOptions, ADryRunCountsOnlyWhatIsWanted)
{
  save("dome.ply", dome());
  EXPECT_EQ(0, dryRun("dome.ply", {}).exit_code);
  EXPECT_EQ(2, dryRun("dome.ply", {"--close", "all"}).exit_code);
  save("tower.ply", openTower());
  EXPECT_EQ(2, dryRun("tower.ply", {}).exit_code);
  EXPECT_EQ(0, dryRun("tower.ply", {"--close", "none"}).exit_code);
}

TEST_F(WishOptions, ThatCannotBeUnderstoodAreRefused)
{
  save("tower.ply", openTower());
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--close", "some"},
        {"--cap", "round"},
        {"--greatest-bridge", "-1"},
        {"--greatest-hole-length", "5mm"},
        {"--greatest-hole-length", "nan"},
        {"--watertight", "--close", "none"},
        {"--watertight", "--greatest-hole", "5"},
        {"--drop-islands", "2.5"},
        {"--drop-islands", "5m2"},
        {"--decisions", folder_.path("missing.json")},
        {"--decisions", folder_.path("tower.ply")}}) {
    const RunResult result = repair("tower.ply", options);
    EXPECT_EQ(1, result.exit_code) << options[0] << options[1];
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ(std::vector<std::string>{"tower.ply"}, folder_.names());
  }
}

TEST_F(WishOptions, OfTheRepairNeedARepairInReconstruction)
{
  save("dome.ply", dome());
  EXPECT_EQ(1,
            runApp("pcl_ccaa_reconstruct",
                   {folder_.path("dome.ply"), folder_.path("out.ply"), "--watertight"})
                .exit_code);
  const RunResult result = runApp(
      "pcl_ccaa_reconstruct",
      {folder_.path("dome.ply"), folder_.path("out.ply"), "--repair", "--watertight"});
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(0U, topologyOfOutput().borders);
}

TEST_F(WishOptions, DecisionsOfADryRunChangeNothing)
{
  app_test::save(folder_.path("caps.ply"), twoCaps());
  ASSERT_EQ(0, repair("caps.ply", {}).exit_code);
  const std::string plain = readFile(folder_.path("out.ply"));
  EXPECT_EQ(2, dryRun("caps.ply", withDecisions()).exit_code);
  ASSERT_EQ(0, repair("caps.ply", withDecisions()).exit_code);
  EXPECT_EQ(plain, readFile(folder_.path("out.ply")));
}

TEST_F(WishOptions, DecisionsListLoopsAndJunctionsWithClassReasonAndConfidence)
{
  app_test::save(folder_.path("caps.ply"), twoCaps());
  dryRun("caps.ply", withDecisions());
  const nlohmann::json json = decisions();
  ASSERT_EQ(2U, json.at("loops").size());
  for (const auto& loop : json.at("loops")) {
    EXPECT_EQ("island rim", loop.at("class"));
    EXPECT_EQ("auto", loop.at("decision"));
    EXPECT_GT(loop.at("confidence"), 0.4);
    EXPECT_NE("", loop.at("reason"));
  }
  ASSERT_EQ(1U, json.at("junctions").size());
  EXPECT_EQ("join", json.at("junctions")[0].at("decision"));
  EXPECT_EQ((std::vector<int>{0, 1}), json.at("junctions")[0].at("loops"));
}

TEST_F(WishOptions, AnEditedJunctionKeepsIslandsApart)
{
  app_test::save(folder_.path("caps.ply"), twoCaps());
  dryRun("caps.ply", withDecisions());
  nlohmann::json json = decisions();
  json["junctions"][0]["decision"] = "do not join";
  write(json);
  const RunResult result = repair("caps.ply", withDecisions());
  EXPECT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(2U, topologyOfOutput().components);
}

TEST_F(WishOptions, AnEditedLoopIsLeftOpen)
{
  save("tower.ply", openTower());
  dryRun("tower.ply", withDecisions());
  nlohmann::json json = decisions();
  json["loops"][0]["decision"] = "leave open";
  write(json);
  EXPECT_EQ(0, repair("tower.ply", withDecisions()).exit_code);
  EXPECT_EQ(1U, topologyOfOutput().borders);
}

TEST_F(WishOptions, AnotherDryRunKeepsWhatWasDecided)
{
  save("tower.ply", openTower());
  dryRun("tower.ply", withDecisions());
  nlohmann::json json = decisions();
  json["loops"][0]["decision"] = "leave open";
  json["loops"][0]["cap"] = "smooth";
  write(json);
  EXPECT_EQ(0, dryRun("tower.ply", withDecisions()).exit_code);
  EXPECT_EQ("leave open", decisions()["loops"][0]["decision"]);
  EXPECT_EQ("smooth", decisions()["loops"][0]["cap"]);
}

TEST_F(WishOptions, DecisionsAboutAnotherMeshAreRefused)
{
  save("tower.ply", openTower());
  save("dome.ply", dome());
  dryRun("tower.ply", withDecisions());
  for (const RunResult& result :
       {repair("dome.ply", withDecisions()), dryRun("dome.ply", withDecisions())}) {
    EXPECT_EQ(1, result.exit_code);
    EXPECT_NE(std::string::npos, result.errors.find("another mesh")) << result.errors;
  }
}

TEST_F(WishOptions, DecisionsThatAreNoneAreRefusedWithTheWordsThereAre)
{
  save("tower.ply", openTower());
  dryRun("tower.ply", withDecisions());
  nlohmann::json json = decisions();
  json["loops"][0]["decision"] = "perhaps";
  write(json);
  const RunResult result = repair("tower.ply", withDecisions());
  EXPECT_EQ(1, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("leave open")) << result.errors;
}

} // namespace
} // namespace app_test
