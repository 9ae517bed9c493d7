// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the last line of runs, and how counts and options are told.
#include <pcl/surface_repair/repair_report.h>

#include "io/wording.h"
#include "mesh/cloud_access.h"
#include "repair_fixture.h"
#include "report/verdict.h"
#include "support/clouds.h"
#include "support/random_source.h"
#include <nlohmann/json.hpp>

namespace app_test {
namespace {

TEST(Wording, HasSingularAndPlural)
{
  EXPECT_EQ("1 hole", app::plural(1, "hole"));
  EXPECT_EQ("0 holes", app::plural(0, "hole"));
  EXPECT_EQ("2 boundaries", app::plural(2, "boundary"));
  EXPECT_EQ("2 days", app::plural(2, "day"));
  EXPECT_EQ("1 region is", app::pluralIs(1, "region"));
  EXPECT_EQ("2 regions are", app::pluralIs(2, "region"));
  EXPECT_EQ("1 point has", app::pluralHas(1, "point"));
  EXPECT_EQ("2 points have", app::pluralHas(2, "point"));
}

TEST(SurfaceVerdict, OfAClosedSurfaceIsWatertight)
{
  app::SurfaceFacts facts;
  facts.pieces = 1;
  EXPECT_EQ("watertight, 1 piece", app::tellSurface(facts));
}

TEST(SurfaceVerdict, NamesReasonsOfABoundaryLeftOpen)
{
  app::SurfaceFacts facts;
  facts.left_open = 3;
  facts.reasons = "2 INTERSECTION, 1 UNDECIDED";
  EXPECT_EQ("3 boundaries left open (2 INTERSECTION, 1 UNDECIDED)",
            app::tellSurface(facts));
}

TEST(SurfaceVerdict, TellsBordersThatMayBeOpen)
{
  app::SurfaceFacts facts;
  facts.borders = 1;
  facts.pieces = 2;
  EXPECT_EQ("1 border open, 2 pieces", app::tellSurface(facts));
}

TEST(SurfaceVerdict, DoesNotCallABoundaryABorderThatMayBeAHole)
{
  app::SurfaceFacts facts;
  facts.open = 2;
  EXPECT_EQ("2 boundaries open", app::tellSurface(facts));
}

TEST(SurfaceVerdict, CountsOpeningsThatAreNoHoles)
{
  pcl::RepairReport report;
  report.counts_after.islands = 2;
  report.after.boundary_loops = 1; // the rim of a flap that was cut off
  EXPECT_EQ("1 border open, 2 pieces", app::tellSurface(app::surfaceFacts(report)));
}

TEST(SurfaceVerdict, OfAFaultySurfaceIsNotWatertight)
{
  app::SurfaceFacts facts;
  facts.faults = 2;
  EXPECT_EQ("2 faults", app::tellSurface(facts));
}

/** \brief What a run prints last, on stdout or, where that is taken, on stderr. */
class RunVerdict : public RepairApp {
protected:
  void
  SetUp() override
  {
    const test::Shape sphere = test::icosphere(3);
    save(folder_.path("closed.ply"), test::toPolygonMesh(sphere));
    save(folder_.path("band.ply"), test::toPolygonMesh(test::moebiusBand(40)));
    save(folder_.path("holed.ply"),
         test::toPolygonMesh(test::withoutTriangles(sphere, {0, 1, 2, 3})));
  }

  RunResult
  run(const std::string& command) const
  {
    return runInShell("cd " + folder_.path("") + "; " + command);
  }

  static std::string
  lastLine(const std::string& text)
  {
    const std::size_t end = text.size() < 2 ? text.size() : text.size() - 1;
    const std::size_t start = text.rfind('\n', end - 1);
    return text.substr(start == std::string::npos ? 0 : start + 1);
  }
};

/** Two layers of random points, nearer to each other than their points. */
test::Shape
thinPlate()
{
  test::RandomSource random(1);
  test::Shape plate;
  for (const double side : {0.0, 0.7})
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j) {
        const double y = j + random.uniform(); // arguments come in any order
        plate.vertices.emplace_back(i + random.uniform(), y, side);
      }
  return plate;
}

TEST_F(RunVerdict, TellsHandlesThatMayBeTunnelsThroughThinPlaces)
{
  save(folder_.path("plate.ply"), test::toPolygonMesh(thinPlate()));
  const RunResult result = run("pcl_ccaa_reconstruct plate.ply out.ply --report -");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, lastLine(result.errors).find(" THIN_HANDLE)"));
  const auto report = nlohmann::json::parse(result.output);
  EXPECT_GT(report.at("genus"), 0);
  EXPECT_EQ(report.at("genus"), report.at("doubtful_handles"));
  ASSERT_FALSE(report.at("doubts").empty());
  EXPECT_EQ("THIN_HANDLE", report.at("doubts").front().at("reason"));
  EXPECT_NE(std::string::npos, result.errors.find("(one is at point "))
      << result.errors;
}

TEST_F(RunVerdict, IsNotCompleteWhereMostPointsGetNoTriangle)
{
  save(folder_.path("helix.ply"), helix());
  const RunResult result = run("pcl_ccaa_reconstruct helix.ply out.ply --report -");
  EXPECT_EQ(2, result.exit_code);
  const auto report = nlohmann::json::parse(result.output);
  EXPECT_GT(report.at("triangles"), 0);
  EXPECT_NE(std::string::npos, lastLine(result.errors).find(" UNUSED_POINTS)"));
}

TEST_F(RunVerdict, TellsThatLinesWereJoined)
{
  const test::Shape lines{test::terrainLines(12, 60, 10.0), {}};
  save(folder_.path("lines.ply"), test::toPolygonMesh(lines));
  const RunResult result = run("pcl_ccaa_reconstruct lines.ply out.ply --report -");
  EXPECT_EQ(0, result.exit_code);
  EXPECT_GT(nlohmann::json::parse(result.output).at("line_gap"), 0.0);
  EXPECT_NE(std::string::npos, result.errors.find("the points lie in lines"))
      << result.errors;
}

TEST_F(RunVerdict, TellsANeckThatMayJoinTwoBodies)
{
  save(folder_.path("two.ply"), spheresThatTouch(2000, 0.035));
  const RunResult result = run("pcl_ccaa_reconstruct two.ply out.ply --report -");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, lastLine(result.errors).find(" (1 THIN_NECK)"));
  EXPECT_EQ(1, nlohmann::json::parse(result.output).at("thin_necks"));
}

TEST_F(RunVerdict, TellsANeckInWhichAnOpeningIs)
{
  save(folder_.path("two.ply"), spheresThatTouch(1000, 0.025));
  const RunResult result = run("pcl_ccaa_reconstruct two.ply out.ply");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_EQ("incomplete: 1 boundary open, in doubt (1 THIN_NECK)\n",
            lastLine(result.output));
}

TEST_F(RunVerdict, TellsWhereANeckIs)
{
  const pcl::PolygonMesh two = spheresThatTouch(2000, 0.035);
  save(folder_.path("two.ply"), two);
  const RunResult result = run("pcl_ccaa_reconstruct two.ply out.ply --report -");
  const auto doubts = nlohmann::json::parse(result.output).at("doubts");
  ASSERT_EQ(1U, doubts.size());
  EXPECT_EQ("THIN_NECK", doubts[0].at("reason"));
  const std::size_t point = doubts[0].at("points").at(0);
  EXPECT_NE(std::string::npos,
            result.errors.find("(one is at point " + std::to_string(point) + ", "));
  EXPECT_LT((pcl::ccaa::positionView(two.cloud)[point] - Eigen::Vector3d(1.0175, 0, 0))
                .norm(),
            0.3);
}

TEST_F(RunVerdict, TellsWherePiecesTouch)
{
  save(folder_.path("two.ply"), spheresThatTouch(2000, 0.055));
  const RunResult result = run("pcl_ccaa_reconstruct two.ply out.ply --report -");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, lastLine(result.errors).find(" (1 TOUCHING_PIECES)"));
  const auto doubts = nlohmann::json::parse(result.output).at("doubts");
  ASSERT_EQ(1U, doubts.size());
  EXPECT_EQ("TOUCHING_PIECES", doubts[0].at("reason"));
  EXPECT_LT(doubts[0].at("points").at(0), 2000);
  EXPECT_GE(doubts[0].at("points").at(1), 2000);
}

TEST_F(RunVerdict, TellsANeckBesideARepairedHoleOnce)
{
  save(folder_.path("two.ply"), spheresThatTouch(1400, 0.0345));
  const RunResult result = run("pcl_ccaa_reconstruct two.ply out.ply --repair");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_EQ("incomplete: watertight, 1 piece, in doubt (1 THIN_NECK)\n",
            lastLine(result.output));
}

TEST_F(RunVerdict, CountsRepeatedPointsOnce)
{
  test::Shape sphere{test::noisySphere(2000, 0.0), {}};
  const auto once = sphere.vertices;
  for (int copy = 0; copy < 2; ++copy)
    sphere.vertices.insert(sphere.vertices.end(), once.begin(), once.end());
  save(folder_.path("thrice.ply"), test::toPolygonMesh(sphere));
  const RunResult result = run("pcl_ccaa_reconstruct thrice.ply out.ply");
  EXPECT_EQ(0, result.exit_code);
  EXPECT_EQ(0U, lastLine(result.output).find("complete: watertight"));
}

TEST_F(RunVerdict, AdvisesToCleanWhereNoiseMakesHandles)
{
  save(folder_.path("noisy.ply"),
       test::toPolygonMesh({test::noisySphere(4000, 0.06), {}}));
  const std::string advice = "try --clean";
  const RunResult result = run("pcl_ccaa_reconstruct noisy.ply out.ply");
  EXPECT_EQ(2, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find(advice)) << result.errors;
  const RunResult cleaned = run("pcl_ccaa_reconstruct noisy.ply out.ply --clean");
  EXPECT_EQ(std::string::npos, cleaned.errors.find(advice)) << cleaned.errors;
}

TEST_F(RunVerdict, AdvisesToCleanWhereNoiseTearsHoles)
{
  save(folder_.path("lines.ply"),
       test::toPolygonMesh(
           {test::withNoise(test::terrainLines(12, 400, 20.0), 1.1), {}}));
  const RunResult result = run("pcl_ccaa_reconstruct lines.ply out.ply");
  EXPECT_NE(std::string::npos, result.errors.find("the holes are so many"))
      << result.errors;
}

TEST_F(RunVerdict, EndsEveryProgram)
{
  const std::pair<const char*, const char*> verdicts[] = {
      {"pcl_repair_holes holed.ply out.ply", "complete: watertight, 1 piece\n"},
      {"pcl_repair_holes holed.ply out.ply --greatest-hole 3",
       "complete: 1 border open, 1 piece\n"},
      {"pcl_repair_holes band.ply out.ply 2>&1",
       "incomplete: 1 boundary left open (1 ONE_SIDED), 1 piece\n"},
      {"pcl_repair_holes holed.ply --dry-run", "incomplete: 1 hole to close\n"},
      {"pcl_repair_holes closed.ply --dry-run", "complete: nothing to repair\n"},
      {"pcl_repair_holes holed.ply closed.ply --output-folder all",
       "complete: 2 inputs: 2 done, 0 with something left undone, 0 failed\n"},
      {"pcl_ccaa_reconstruct closed.ply out.ply", "complete: watertight\n"},
      {"pcl_ccaa_reconstruct closed.ply out.ply --repair",
       "complete: watertight, 1 piece\n"},
      {"pcl_ccaa_reconstruct closed.ply --dry-run",
       "complete: 642 points to reconstruct\n"},
      {"pcl_mesh_quality holed.ply", "complete: 1 boundary open, 1 piece\n"},
      {"pcl_damage_cloud closed.ply out.ply --sphere 0.5,0.5,0.5,0.01 2>/dev/null",
       "incomplete: 0 points taken out\n"}};
  for (const auto& [command, verdict] : verdicts)
    EXPECT_EQ(verdict, lastLine(run(command).output)) << command;
}

TEST_F(RunVerdict, GoesToStandardErrorWhereTheMeshGoesToStandardOutput)
{
  const RunResult result = run("pcl_repair_holes holed.ply -");
  EXPECT_EQ("complete: watertight, 1 piece\n", lastLine(result.errors));
}

TEST_F(RunVerdict, IsNotPrintedWhenQuietOrFailed)
{
  EXPECT_EQ("", run("pcl_repair_holes holed.ply out.ply -q").output);
  EXPECT_EQ("", run("pcl_repair_holes missing.ply out.ply").output);
}

} // namespace
} // namespace app_test
