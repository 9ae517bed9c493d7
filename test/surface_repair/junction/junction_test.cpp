// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the evidence for junctions and of sight lines.

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/scanned_scene.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "survey/model_survey.h"

#include <algorithm>
#include <limits>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;

ModelSurvey
survey(const Shape& shape)
{
  return surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)), nullptr, {}, {});
}

/** Two sheets, 11 x 29 edges large, the second one moved. */
Shape
twoSheets(const Position& shift)
{
  return joined(grid(12, 30), translated(grid(12, 30), shift));
}

bool
anyJoined(const ModelSurvey& found)
{
  const auto& junctions = found.joined.junctions;
  return std::any_of(junctions.begin(), junctions.end(), [](const Junction& junction) {
    return junction.verdict == JunctionVerdict::JOINED;
  });
}

TEST(SurfaceEnd, ConormalLeavesAFlatSheetAcrossItsBorder)
{
  const IncompleteModel model = modelOf(grid(12, 12));
  const auto vertex = static_cast<pcl::index_t>(
      std::find(model.positions.begin(), model.positions.end(), Position(11, 5, 0)) -
      model.positions.begin());
  const SurfaceEnd end = surfaceEndAt(model, vertex);
  EXPECT_NEAR((end.normal - Direction(0, 0, 1)).norm(), 0.0, 1e-12);
  EXPECT_GT(end.conormal.x(), 0.99);
  EXPECT_NEAR(end.conormal.z(), 0.0, 1e-12);
  EXPECT_GE(end.edge, 1.0);
}

TEST(Junctions, SheetsInOnePlaneAreJoined)
{
  const ModelSurvey found = survey(twoSheets({15, 0, 0}));
  ASSERT_EQ(found.joined.junctions.size(), 1u);
  const Junction& junction = found.joined.junctions.front();
  EXPECT_EQ(junction.verdict, JunctionVerdict::JOINED);
  EXPECT_NEAR(junction.evidence.fold, 0.0, 1e-9);
  EXPECT_LT(junction.evidence.turn, 0.3);
  EXPECT_NEAR(junction.evidence.gap, 4.0, 0.5);
}

TEST(Junctions, SheetsOneBehindTheOtherAreDifferentObjects)
{
  const ModelSurvey found = survey(twoSheets({6, 0, 12}));
  EXPECT_FALSE(anyJoined(found));
  EXPECT_TRUE(found.joined.bridges.empty());
}

TEST(Junctions, WithoutJudgingEveryPairIsJoined)
{
  SurveyParameters parameters;
  parameters.junction.judge = false;
  const ModelSurvey found = surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(twoSheets({6, 0, 12}))),
      nullptr,
      parameters,
      {});
  for (const Junction& junction : found.joined.junctions) {
    EXPECT_EQ(junction.verdict, JunctionVerdict::JOINED);
    EXPECT_EQ(junction.believed, junction.lines);
  }
}

/** What lines over a wide gap say between surfaces that are bent so much against it. */
JunctionEvidence
wideGap(double turn, double along_ray)
{
  JunctionEvidence evidence;
  evidence.turn = turn;
  evidence.gap_edges = 8.0;
  evidence.along_ray = along_ray;
  return evidence;
}

TEST(Junctions, DepthSpeaksAgainstASurfaceThatBends)
{
  const double across = wideGap(1.0, 0.0).logOdds();
  EXPECT_LT(wideGap(1.0, 0.25).logOdds(), across - 0.5);
  EXPECT_LT(wideGap(1.0, 0.5).logOdds(), across - 1.5);
}

TEST(Junctions, DepthSaysNothingOfASurfaceThatGoesStraightOn)
{
  EXPECT_EQ(wideGap(0.0, 1.0).logOdds(), wideGap(0.0, 0.0).logOdds());
}

/** A wall in z = 0, seen from z = 10. */
IncompleteModel
wallSeenFromAbove()
{
  IncompleteModel model = modelOf(grid(21, 21));
  model.viewpoints.assign(model.positions.size(), Position(10, 10, 10));
  return model;
}

TEST(SightLines, PlacesBeforeAMeasuredWallAreSeenEmpty)
{
  const SightLines sight(wallSeenFromAbove());
  EXPECT_EQ(sight.seenEmpty({{10, 10, 5}, {12, 9, 5}}), 1.0);
}

TEST(SightLines, PlacesBehindAndBesideAMeasuredWallAreNot)
{
  const SightLines sight(wallSeenFromAbove());
  EXPECT_EQ(sight.seenEmpty({{10, 10, -1}, {60, 10, 5}}), 0.0);
}

TEST(SightLines, TheWallItselfIsNotSeenThrough)
{
  const IncompleteModel model = wallSeenFromAbove();
  EXPECT_EQ(SightLines(model).seenEmpty(model.positions), 0.0);
}

TEST(SightLines, AJumpInDepthRunsAlongTheRay)
{
  const SightLines sight(wallSeenFromAbove());
  EXPECT_NEAR(sight.alongRay({10, 10, 1}, {10, 10, -1}), 1.0, 1e-12);
  EXPECT_NEAR(sight.alongRay({9, 10, 0}, {11, 10, 0}), 0.0, 1e-12);
}

TEST(SightLines, AModelWithoutSensorsHasNone)
{
  EXPECT_TRUE(SightLines(modelOf(grid(4, 4))).empty());
}

std::size_t
objectAt(const Scene& scene, const Position& place)
{
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    for (const Position& vertex : scene.objects[i].vertices)
      if ((vertex - place).squaredNorm() < least) {
        least = (vertex - place).squaredNorm();
        nearest = i;
      }
  return nearest;
}

/** How many bridges of a range map lead from one object to another. */
std::size_t
wrongBridges(const Scene& scene, const Shape& map, bool judge)
{
  SurveyParameters parameters;
  parameters.junction.judge = judge;
  parameters.trace_in_holes = false;
  const ModelSurvey found = surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(map)), nullptr, parameters, {});
  const auto& bridges = found.joined.bridges;
  return static_cast<std::size_t>(
      std::count_if(bridges.begin(), bridges.end(), [&](const Bridge& bridge) {
        return objectAt(scene, bridge.points.front()) !=
               objectAt(scene, bridge.points.back());
      }));
}

TEST(Junctions, KeepBridgesFromLeadingFromOneObjectToAnother)
{
  std::size_t judged = 0;
  std::size_t not_judged = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Scene scene = randomScene(seed);
    ViewSettings view;
    view.pixels = 100;
    view.seed = seed;
    const Shape map = rangeMap(scene, view);
    judged += wrongBridges(scene, map, true);
    not_judged += wrongBridges(scene, map, false);
  }
  EXPECT_GT(not_judged, 50u);
  EXPECT_LT(10 * judged, not_judged);
}

} // namespace
} // namespace pcl::repair
