// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of how much work a repair takes, how soon it can be
// left, and what it tells about that.

#include "repair/repair_method.h"
#include "repair/whole_progress.h"
#include "support/repair_fixture.h"
#include "survey/survey_stages.h"

#include <cmath>
#include <limits>
#include <utility>

namespace pcl::repair {
namespace {

using namespace test;

/** One hole of some 200 edges; what fills it has more unknowns than small systems. */
Shape
widelyOpenSphere()
{
  return inPieces(icosphere(5), [](const Position& p) { return p.z() > 0.2 ? -1 : 0; });
}

RepairParameters
closingAll()
{
  RepairParameters parameters;
  parameters.filling.close = CloseChoice::ALL;
  parameters.filling.cap = Cap::SMOOTH;
  return parameters;
}

/** Slices of a torus, so that there is much to be joined. */
Shape
slicedTorus()
{
  return inPieces(torus(240, 80), [](const Position& p) {
    const double turn = std::atan2(p.y(), p.x()) + M_PI;
    return std::fmod(turn, 0.5) < 0.1 ? -1 : static_cast<int>(turn / 0.5);
  });
}

/** A sphere of which a third lies in crumbs. */
Shape
crumbledSphere()
{
  return inPieces(icosphere(5), [](const Position& p) {
    const double x = 6.0 * (p.x() + 2.0), y = 6.0 * (p.y() + 2.0);
    const bool is_whole = p.z() < 0.3;
    const bool is_gap =
        p.z() < 0.4 || x - std::floor(x) < 0.4 || y - std::floor(y) < 0.4;
    const int crumb = 1 + 24 * static_cast<int>(x) + static_cast<int>(y);
    return is_whole ? 0 : is_gap ? -1 : crumb;
  });
}

class BoundedWorkOf : public ::testing::TestWithParam<Shape (*)()> {};

TEST_P(BoundedWorkOf, LittleIsDoneBetweenTwoQuestions)
{
  const pcl::PolygonMesh mesh = toPolygonMesh(GetParam()());
  const RepairParameters parameters = closingAll();
  ccaa::RunControl control;
  const ccaa::LoopContext context{1, &control};
  RepairReport report;
  ModelSurvey survey = readSurvey(
      pcl::make_shared<pcl::PolygonMesh>(mesh), nullptr, parameters.survey, context);
  const RepairedModel repaired =
      repairModel(std::move(survey), mesh.cloud, parameters, context, report);
  EXPECT_GT(repaired.model.triangles.size(), mesh.polygons.size());
  EXPECT_GT(control.work(), 5 * ccaa::RunControl::PATIENCE);
  EXPECT_LE(control.longestUnasked(), 2 * ccaa::RunControl::PATIENCE);
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         BoundedWorkOf,
                         ::testing::Values(widelyOpenSphere,
                                           slicedTorus,
                                           crumbledSphere));

TEST(BoundedWork, ARunCanBeLeftAtManyPoints)
{
  const auto mesh =
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(widelyOpenSphere()));
  const auto callsUntil = [&](int most) {
    int calls = 0;
    ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setParameters(closingAll());
    repair.setNumberOfThreads(1);
    repair.setProgressCallback(
        [&](const std::string&, double) { return ++calls < most; });
    pcl::PolygonMesh output;
    repair.process(output);
    EXPECT_EQ(calls == most, repair.getReport().cancelled) << most;
    EXPECT_EQ(calls == most, output.polygons.empty()) << most;
    return calls;
  };
  const int all = callsUntil(std::numeric_limits<int>::max());
  EXPECT_GT(all, 30);
  for (int tenth = 1; tenth < 10; ++tenth)
    callsUntil(tenth * all / 10);
}

TEST(BoundedWork, ProgressNeverFallsAndEndsAtOne)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(
      toPolygonMesh(inPieces(icosphere(4), [](const Position& p) {
        return std::abs(p.x()) < 0.1 || std::abs(p.y()) < 0.1 ? -1 : 0;
      })));
  double last = 0.0;
  ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  repair.setProgressCallback([&](const std::string& stage, double share) {
    EXPECT_GE(share, last) << stage;
    EXPECT_LE(share, 1.0) << stage;
    last = share;
    return true;
  });
  pcl::PolygonMesh output;
  repair.process(output);
  EXPECT_EQ(1.0, last);
}

TEST(WholeProgress, LeavesRoomForWhatComesAfterAStage)
{
  double whole = 0.0;
  WholeProgress progress([&](const std::string&, double share) {
    whole = share;
    return true;
  });
  progress.tell("closing", 1.0);
  EXPECT_DOUBLE_EQ(0.5, whole);
  progress.tell("closing, pass 2 of at most 5", 0.0);
  EXPECT_DOUBLE_EQ(0.5, whole);
  progress.tell("closing, pass 2 of at most 5", 1.0);
  EXPECT_DOUBLE_EQ(0.75, whole);
  progress.tell("writing", 1.0);
  EXPECT_DOUBLE_EQ(1.0, whole);
}

TEST(WholeProgress, StaysWhereItIsWhereNothingWasReportedYet)
{
  double whole = 0.0;
  std::string last;
  WholeProgress progress([&](const std::string& stage, double share) {
    last = stage;
    whole = share;
    return true;
  });
  progress.tell("reading", 1.0);
  const double read = whole;
  progress.tell("", 0.0);
  EXPECT_EQ("reading", last);
  EXPECT_EQ(read, whole);
}

TEST(WholeProgress, DoesNotFallWhereAStageBeginsAnew)
{
  double whole = 0.0;
  WholeProgress progress([&](const std::string&, double share) {
    EXPECT_GE(share, whole);
    whole = share;
    return true;
  });
  for (const double share : {0.5, 1.0, 0.1, 1.0, 0.0, 0.7})
    progress.tell("reading", share);
  EXPECT_LE(whole, 1.0);
}

} // namespace
} // namespace pcl::repair
