// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of counting the handles that bridges make, and of
// giving up those that nothing supports.

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "survey/handle_choice.h"
#include "survey/survey_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::without;

BoundaryEdges
boundariesOf(const ModelSurvey& survey)
{
  SourceSet sources;
  for (const std::size_t loop : survey.joined.loops) {
    sources.curves.emplace_back();
    sources.curves.back().loop = loop;
    sources.curves.back().island = survey.loops[loop].island;
  }
  return targetsOf(sources, survey.loops);
}

template <typename IsLost>
ModelSurvey
surveyOfSphereWithout(const IsLost& is_lost)
{
  return surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(without(icosphere(4), is_lost))),
      nullptr,
      {},
      {});
}

/** Two halves of a sphere, the boundaries of both, and three pairs of bridges
 * between them. */
class HandleChoice : public testing::Test {
protected:
  HandleChoice()
  : survey_(
        surveyOfSphereWithout([](const Position& p) { return std::abs(p.z()) < 0.08; }))
  , boundaries_(boundariesOf(survey_))
  {
    std::vector<Bridge>& bridges = survey_.joined.bridges;
    for (Bridge& bridge : bridges)
      if (bridge.begin.curve != 0)
        std::swap(bridge.begin, bridge.end);
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) {
      return angleOf(a) < angleOf(b);
    });
    const std::size_t third = bridges.size() / 3;
    bridges = {bridges[0],
               bridges[1],
               bridges[third],
               bridges[third + 1],
               bridges[2 * third],
               bridges[2 * third + 1]};
    extract();
  }

  static double
  angleOf(const Bridge& bridge)
  {
    return std::atan2(bridge.begin.position.y(), bridge.begin.position.x());
  }

  void
  extract()
  {
    survey_.joined.holes = extractContours(boundaries_, survey_.joined.bridges);
  }

  /** Two of the pairs cross, as if one led through a tube. */
  void
  twist()
  {
    std::vector<Bridge>& bridges = survey_.joined.bridges;
    std::swap(bridges[0].end, bridges[2].end);
    std::swap(bridges[1].end, bridges[3].end);
    extract();
  }

  BridgedTopology
  topology() const
  {
    return bridgedTopology(survey_, survey_.joined);
  }

  ModelSurvey survey_;
  BoundaryEdges boundaries_;
};

TEST_F(HandleChoice, BridgesSideBySideMakeNoHandle)
{
  ASSERT_EQ(2U, survey_.joined.loops.size());
  EXPECT_EQ(1U, topology().pieces);
  EXPECT_EQ(0, topology().handles);
  EXPECT_EQ(0, topology().in_gaps);
}

TEST_F(HandleChoice, CrossedPairsMakeAHandleWithinTheGap)
{
  twist();
  EXPECT_EQ(1U, topology().pieces);
  EXPECT_EQ(1, topology().handles);
  EXPECT_EQ(1, topology().in_gaps);
}

TEST_F(HandleChoice, OfCrossedPairsOneGoesHoweverLikelyTheJunctionIs)
{
  twist();
  ASSERT_EQ(1U, survey_.joined.junctions.size());
  ASSERT_GT(survey_.joined.junctions.front().confidence, 0.95);
  dropHandles(survey_, boundaries_, survey_.joined);
  EXPECT_EQ(1U, topology().pieces);
  EXPECT_EQ(0, topology().handles);
  EXPECT_EQ(4U, survey_.joined.bridges.size());
}

void
lowerOdds(double most, JunctionEvidence& evidence)
{
  while (evidence.logOdds() > most)
    evidence.seen_empty += 0.001;
}

/** Handles of a sphere in three slices, of which the outer ones are connected by a
 * strip of so many bridges through the body, whose junction has at most such log odds,
 * after those that nothing supports are given up. */
long
handlesWithStrip(std::size_t width, double odds)
{
  ModelSurvey survey = surveyOfSphereWithout(
      [](const Position& p) { return std::abs(std::abs(p.z()) - 0.4) < 0.08; });
  const auto outerEnd = [](const Bridge& bridge) {
    const bool begins = std::abs(bridge.begin.position.z()) > 0.4;
    return begins ? bridge.begin : bridge.end;
  };
  const auto angle = [&](const Bridge& bridge) {
    const Position& p = outerEnd(bridge).position;
    return std::atan2(p.y(), p.x());
  };
  std::vector<Bridge>& bridges = survey.joined.bridges;
  std::sort(bridges.begin(), bridges.end(), [&](const Bridge& a, const Bridge& b) {
    return angle(a) < angle(b);
  });
  const auto takeOuterEnds = [&](bool above) {
    std::vector<BoundaryPoint> ends;
    for (auto b = bridges.begin(); b != bridges.end() && ends.size() < width;)
      if ((outerEnd(*b).position.z() > 0.0) == above) {
        ends.push_back(outerEnd(*b));
        b = bridges.erase(b);
      }
      else
        ++b;
    return ends;
  };
  const std::vector<BoundaryPoint> upper = takeOuterEnds(true);
  const std::vector<BoundaryPoint> lower = takeOuterEnds(false);
  EXPECT_EQ(2U, survey.joined.junctions.size());
  Junction junction = survey.joined.junctions.front();
  junction.curves = {std::min(upper[0].curve, lower[0].curve),
                     std::max(upper[0].curve, lower[0].curve)};
  lowerOdds(odds, junction.evidence);
  survey.joined.junctions.push_back(junction);
  for (std::size_t i = 0; i < width; ++i) {
    Bridge bridge = bridges.front();
    bridge.begin = upper[i];
    bridge.end = lower[i];
    bridges.push_back(bridge);
  }
  const BoundaryEdges boundaries = boundariesOf(survey);
  survey.joined.holes = extractContours(boundaries, bridges);
  EXPECT_EQ(1, bridgedTopology(survey, survey.joined).handles);
  dropHandles(survey, boundaries, survey.joined);
  EXPECT_EQ(1U, bridgedTopology(survey, survey.joined).pieces);
  return bridgedTopology(survey, survey.joined).handles;
}

/** Bent so far, degrees, with log odds a little above these. */
JunctionEvidence
bentJunction(double bend, double odds)
{
  JunctionEvidence evidence;
  evidence.turn = bend * M_PI / 180.0;
  evidence.has_sight = true;
  lowerOdds(odds + 0.1, evidence);
  EXPECT_GT(evidence.logOdds(), odds);
  return evidence;
}

TEST(CarriesHandle, WhatIsStraightOrSure)
{
  EXPECT_TRUE(carriesHandle(bentJunction(115.0, 1.0)));
  EXPECT_FALSE(carriesHandle(bentJunction(125.0, 3.4)));
  EXPECT_TRUE(carriesHandle(bentJunction(125.0, 3.7)));
  EXPECT_TRUE(carriesHandle(bentJunction(135.0, 3.7)));
}

TEST(CarriesHandle, SurelyWhereWhatIsFarBentIsSurer)
{
  EXPECT_FALSE(surelyCarriesHandle(bentJunction(125.0, 3.4)));
  EXPECT_TRUE(surelyCarriesHandle(bentJunction(125.0, 3.7)));
  EXPECT_FALSE(surelyCarriesHandle(bentJunction(135.0, 3.7)));
  EXPECT_TRUE(surelyCarriesHandle(bentJunction(135.0, 4.4)));
}

TEST(HandleOverStrip, GoesWhereTwoBridgesCarryIt)
{
  EXPECT_EQ(0, handlesWithStrip(2, 3.0));
}

TEST(HandleOverStrip, StaysWhereFourBridgesCarryIt)
{
  EXPECT_EQ(1, handlesWithStrip(4, 3.0));
}

TEST(HandleOverStrip, StaysWhereTheJunctionIsSure)
{
  EXPECT_EQ(1, handlesWithStrip(2, 5.0));
}

} // namespace
} // namespace pcl::repair
