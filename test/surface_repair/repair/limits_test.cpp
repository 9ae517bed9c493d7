// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what users allow a repair to close and to join.

#include "mesh/surface_topology.h"
#include "support/repair_fixture.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace test;

/** A sphere of radius 1 without its two poles, the upper opening the smaller one: a
 * barrel with openings of radius 0.4 and 0.6. */
Shape
twoHoles()
{
  return inPieces(icosphere(4), [](const Position& p) {
    return p.z() > std::sqrt(1.0 - 0.16) || p.z() < -0.8 ? -1 : 0;
  });
}

/** A sphere without a belt, half as wide as it is high. */
Shape
twoCaps()
{
  return inPieces(icosphere(4), [](const Position& p) {
    return std::abs(p.z()) < 0.15 ? -1 : p.z() > 0.0 ? 1 : 0;
  });
}

std::size_t
countOpen(const Repaired& result, OpenReason reason)
{
  const auto& holes = result.report.holes;
  return static_cast<std::size_t>(std::count_if(
      holes.begin(), holes.end(), [&](const auto& h) { return h.open == reason; }));
}

RepairParameters
closing(CloseChoice choice)
{
  RepairParameters parameters;
  parameters.filling.close = choice;
  return parameters;
}

TEST(RepairLimits, CloseAllClosesTheBorderOfACurvedSheet)
{
  const Shape sheet =
      inPieces(icosphere(4), [](const Position& p) { return p.z() < 0.3 ? -1 : 0; });
  ASSERT_EQ(1U, countOpen(repaired(sheet), OpenReason::OUTER_BORDER));
  const Repaired result = repaired(sheet, closing(CloseChoice::ALL));
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  EXPECT_TRUE(result.report.complete());
  expectNothingWorse(result, sheet.triangles);
}

TEST(RepairLimits, CloseAllClosesTheMouthsOfATube)
{
  const Shape tube = cylinder(40, 40, 1.0, 6.0);
  ASSERT_EQ(2U, countOpen(repaired(tube), OpenReason::TUBE_MOUTH));
  const Repaired result = repaired(tube, closing(CloseChoice::ALL));
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  expectNothingWorse(result, tube.triangles);
}

TEST(RepairLimits, CloseAllJoinsIslandsBeforeItClosesTheirRims)
{
  const Repaired result = repaired(twoCaps(), closing(CloseChoice::ALL));
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
}

TEST(RepairLimits, CloseAllClosesWhatNoBridgeJoins)
{
  RepairParameters parameters = closing(CloseChoice::ALL);
  parameters.join_islands = false;
  Shape shape = inPieces(icosphere(4), [](const Position& p) {
    return p.z() > 0.3 ? 1 : p.z() < -0.3 ? 0 : -1;
  });
  for (Position& p : shape.vertices)
    p.z() += p.z() > 0.0 ? 2.0 : 0.0;
  const Repaired result = repaired(shape, parameters);
  EXPECT_EQ(2U, topologyOf(result.triangles()).components);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, CloseNothingLeavesHolesOpenWithoutAShortfall)
{
  const Repaired result = repaired(twoHoles(), closing(CloseChoice::NOTHING));
  EXPECT_EQ(2U, countOpen(result, OpenReason::NOT_WANTED));
  EXPECT_EQ(result.input.polygons.size(), result.output.polygons.size());
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, CloseNothingStillJoinsIslands)
{
  const Shape shape = inPieces(icosphere(4), [](const Position& p) {
    return std::abs(p.z()) < 0.15 || p.z() > 0.95 ? -1 : p.z() > 0.0 ? 1 : 0;
  });
  const Repaired result = repaired(shape, closing(CloseChoice::NOTHING));
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  EXPECT_EQ(1U, topologyOf(result.triangles()).borders);
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, LongerHolesThanTheGreatestStayOpenWithoutAShortfall)
{
  RepairParameters parameters;
  parameters.filling.greatest_length = 3.3; // between 2 pi 0.4 and 2 pi 0.6
  const Repaired result = repaired(twoHoles(), parameters);
  EXPECT_EQ(1U, countOpen(result, OpenReason::TOO_LARGE));
  EXPECT_EQ(1U, topologyOf(result.triangles()).borders);
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, AShareOfTheDiagonalIsALength)
{
  const Shape shape = scaled(twoHoles(), 1000.0);
  RepairParameters parameters;
  parameters.filling.greatest_length = {1.0, true}; // 2 x 2 x 1.7: about 3.3 radii
  EXPECT_EQ(1U, countOpen(repaired(shape, parameters), OpenReason::TOO_LARGE));
}

TEST(RepairLimits, LongerBridgesThanTheGreatestAreNotBuilt)
{
  RepairParameters parameters;
  parameters.survey.greatest_bridge = 0.2; // the gap is 0.3 wide
  const Repaired result = repaired(twoCaps(), parameters);
  EXPECT_EQ(2U, topologyOf(result.triangles()).components);
  EXPECT_EQ(2U, countOpen(result, OpenReason::NOT_WANTED));
  EXPECT_TRUE(result.report.complete());
  parameters.survey.greatest_bridge = 0.5;
  EXPECT_EQ(1U, topologyOf(repaired(twoCaps(), parameters).triangles()).components);
}

TEST(RepairLimits, IslandsThatWereNotToBeJoinedAreNoShortfall)
{
  RepairParameters parameters;
  parameters.join_islands = false;
  const Repaired result = repaired(twoCaps(), parameters);
  EXPECT_EQ(2U, countOpen(result, OpenReason::NOT_WANTED));
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, AWatertightSurfaceHasNoBoundary)
{
  RepairParameters parameters;
  parameters.watertight = true;
  const Repaired result = repaired(cylinder(40, 40, 1.0, 6.0), parameters);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  EXPECT_TRUE(result.report.complete());
}

TEST(RepairLimits, WhatStaysOpenOfAWatertightSurfaceIsAShortfall)
{
  RepairParameters parameters;
  parameters.watertight = true;
  const Shape band = moebiusBand(40); // nothing closes what has no two sides
  const Repaired result = repaired(band, parameters);
  ASSERT_EQ(1U, result.report.holes.size());
  EXPECT_NE(OpenReason::NONE, result.report.holes[0].open);
  EXPECT_EQ(1U, result.report.shortfalls);
  expectNothingWorse(result, band.triangles);
}

TEST(RepairLimits, IslandsAreNotCountedAsJoinedWhereTheHolesBetweenThemStayOpen)
{
  RepairParameters parameters;
  parameters.filling.greatest_length = 0.1;
  EXPECT_EQ(2U, repaired(twoCaps(), parameters).report.counts_after.islands);
}

TEST(RepairLimits, NegativeLimitsAreRefused)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  RepairParameters parameters;
  parameters.survey.greatest_bridge = -1.0;
  EXPECT_TRUE(repaired(twoCaps(), parameters).output.polygons.empty());
}

} // namespace
} // namespace pcl::repair
