// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what a finished model leaves in doubt.

#include "decision/cut_loops.h"
#include "support/repair_fixture.h"
#include "verification/junction_doubts.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace test;

Shape
lacking(const Shape& shape, const std::function<bool(const Position&)>& is_lost)
{
  return inPieces(shape, [&](const Position& p) { return is_lost(p) ? -1 : 0; });
}

std::size_t
countDoubts(const Repaired& result, DoubtReason reason)
{
  const auto& doubts = result.report.doubts;
  return static_cast<std::size_t>(
      std::count_if(doubts.begin(), doubts.end(), [&](const RepairDoubt& doubt) {
        return doubt.reason == reason;
      }));
}

/** A sphere pressed flat, without what lies around its poles. */
Shape
discWithOppositeHoles(double thickness)
{
  Shape shape = lacking(
      icosphere(4), [](const Position& p) { return std::hypot(p.x(), p.y()) < 0.4; });
  for (Position& p : shape.vertices)
    p.z() *= thickness;
  return shape;
}

TEST(Doubts, OppositeHolesOfAPlateMayBeATunnel)
{
  const Repaired result = repaired(discWithOppositeHoles(0.15));
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_EQ(0U, result.report.shortfalls);
  EXPECT_FALSE(result.report.complete());
  ASSERT_EQ(1U, result.report.doubts.size());
  const RepairDoubt& doubt = result.report.doubts.front();
  EXPECT_EQ(DoubtReason::TUNNEL, doubt.reason);
  // Two circles with a radius of 0.4, and 0.27 between the middles of their caps.
  EXPECT_NEAR(0.27 / 0.4, doubt.ratio, 0.1);
  const auto points = ccaa::positionView(result.input.cloud);
  for (const pcl::index_t point : doubt.points) {
    const Position p = points[static_cast<std::size_t>(point)];
    EXPECT_NEAR(0.4, std::hypot(p.x(), p.y()), 0.1);
  }
}

TEST(Doubts, ACrumbWithinACapDoesNotHideATunnel)
{
  Shape crumb;
  for (const double angle : {0.0, 2.0, 4.0})
    crumb.vertices.emplace_back(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.145);
  crumb.triangles.push_back({0, 1, 2});
  const Repaired result = repaired(joined(discWithOppositeHoles(0.15), crumb));
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  ASSERT_FALSE(result.report.doubts.empty());
  EXPECT_EQ(DoubtReason::TUNNEL, result.report.doubts.front().reason);
}

TEST(Doubts, ACrumbFarBeyondAHoleIsOne)
{
  const auto tipOf = [](double lift) {
    Shape tip = withoutFreeVertices(
        lacking(ellipsoid(4, 4.0), [](const Position& p) { return p.z() < 3.9; }));
    return translated(tip, Position(0.0, 0.0, lift));
  };
  const Shape stump =
      lacking(ellipsoid(4, 4.0), [](const Position& p) { return p.z() > 3.0; });
  for (const bool is_far : {false, true}) {
    SCOPED_TRACE(is_far);
    const Repaired result = repaired(joined(stump, tipOf(is_far ? 1.0 : 0.0)));
    EXPECT_EQ(1U, topologyOf(result.triangles()).components);
    EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
    EXPECT_EQ(is_far, countDoubts(result, DoubtReason::LONG_GAP) > 0);
  }
}

/** Their thin neck may be lost. */
TEST(Doubts, ClosedPiecesThatTouchAreOne)
{
  const Shape ball =
      lacking(icosphere(4), [](const Position& p) { return p.z() > 0.9; });
  for (const double gap : {0.02, 0.3}) {
    SCOPED_TRACE(gap);
    const Repaired result =
        repaired(joined(ball, translated(ball, Position(2.0 + gap, 0.0, 0.0))));
    EXPECT_EQ(2U, topologyOf(result.triangles()).components);
    EXPECT_EQ(gap < 0.1 ? 1U : 0U, countDoubts(result, DoubtReason::UNJOINED));
  }
}

TEST(Doubts, PiecesThatTouchedBeforeAreNone)
{
  const Repaired result = repaired(joined(
      joined(icosphere(4), translated(icosphere(4), Position(2.02, 0.0, 0.0))),
      translated(lacking(icosphere(4), [](const Position& p) { return p.z() > 0.9; }),
                 Position(0.0, 9.0, 0.0))));
  EXPECT_EQ(3U, topologyOf(result.triangles()).components);
  EXPECT_EQ(0U, countDoubts(result, DoubtReason::UNJOINED));
}

/** Two spheres that touch, without one triangle where a point is asked. */
Shape
neckLacking(const std::function<bool(const Position&)>& is_there)
{
  const Shape shape = spheresJoinedByTube(0.1, 1);
  const auto at = std::find_if(
      shape.triangles.begin(), shape.triangles.end(), [&](const Triangle& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [&](pcl::index_t v) {
          return is_there(shape.vertices[static_cast<std::size_t>(v)]);
        });
      });
  return withoutTriangles(shape,
                          {static_cast<std::size_t>(at - shape.triangles.begin())});
}

Shape
partOfNeck()
{
  return neckLacking(
      [](const Position& p) { return std::hypot(p.x(), p.y(), p.z()) < 0.25; });
}

TEST(Doubts, AThinNeckThatIsPartlyNewIsOne)
{
  const Repaired result = repaired(partOfNeck());
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_EQ(1U, countDoubts(result, DoubtReason::THIN_NECK));
}

TEST(Doubts, AThinNeckThatWasGivenIsNone)
{
  const Repaired result =
      repaired(neckLacking([](const Position& p) { return p.x() > 1.8; }));
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_EQ(0U, countDoubts(result, DoubtReason::THIN_NECK));
}

TEST(Doubts, AThinNeckAboutWhichUsersDecideIsNone)
{
  const Repaired result = decided(partOfNeck(), proposed(partOfNeck()));
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_EQ(0U, countDoubts(result, DoubtReason::THIN_NECK));
}

TEST(Doubts, AThinNeckInAPartThatWasCutOffIsOne)
{
  const Shape part =
      lacking(partOfNeck(), [](const Position& p) { return p.x() > 1.5; });
  const auto isUncut = [&](pcl::index_t from, pcl::index_t to) {
    const auto x = [&](auto v) {
      return part.vertices[static_cast<std::size_t>(v)].x();
    };
    return std::max(x(from), x(to)) < 1.0;
  };
  RepairParameters parameters;
  parameters.survey.decisions =
      leaveCutsOpen(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(part)), isUncut);
  const Repaired result = repaired(part, parameters);
  EXPECT_EQ(1U, topologyOf(result.triangles()).borders);
  EXPECT_EQ(1U, countDoubts(result, DoubtReason::THIN_NECK));
}

TEST(Doubts, OppositeHolesOfAThickBodyAreNone)
{
  const Repaired result = repaired(discWithOppositeHoles(1.0));
  EXPECT_TRUE(result.report.complete());
  EXPECT_TRUE(result.report.doubts.empty());
}

/** What is proposed, and a junction between the two holes. */
Decisions
withJunction(bool join)
{
  Decisions decisions = proposed(discWithOppositeHoles(0.15));
  JunctionDecision junction;
  junction.first_loop = 0;
  junction.second_loop = 1;
  junction.join = join;
  decisions.junctions.push_back(junction);
  return decisions;
}

TEST(Doubts, TheUserMayWantTheCaps)
{
  const Shape disc = discWithOppositeHoles(0.15);
  EXPECT_FALSE(decided(disc, proposed(disc)).report.complete());
  const Repaired result = decided(disc, withJunction(false));
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_TRUE(result.report.complete());
}

TEST(Doubts, TheUserMayWantTheTunnel)
{
  const Repaired result = decided(discWithOppositeHoles(0.15), withJunction(true));
  EXPECT_EQ(0, topologyOf(result.triangles()).characteristic);
  EXPECT_EQ(0U, topologyOf(result.triangles()).borders);
  EXPECT_TRUE(addsNoIntersection(result));
}

/** A sphere of which 0.3 is lost on one side. */
Shape
bowl()
{
  return lacking(icosphere(4), [](const Position& p) { return p.z() > 0.4; });
}

TEST(Doubts, ALargePartThatIsNewMayHideMore)
{
  const Repaired result = repaired(bowl());
  EXPECT_EQ(2, topologyOf(result.triangles()).characteristic);
  EXPECT_FALSE(result.report.complete());
  ASSERT_EQ(1U, result.report.doubts.size());
  EXPECT_EQ(DoubtReason::UNSUPPORTED, result.report.doubts.front().reason);
  EXPECT_GT(result.report.doubts.front().ratio, 0.2);
  EXPECT_LT(result.report.doubts.front().ratio, 0.4);
}

TEST(Doubts, ALimitOfOneAcceptsAllThatIsNew)
{
  RepairParameters parameters;
  parameters.greatest_unsupported = 1.0;
  EXPECT_TRUE(repaired(bowl(), parameters).report.complete());
}

TEST(Doubts, WhatIsToBeClosedAnywayIsNone)
{
  RepairParameters parameters;
  parameters.filling.close = CloseChoice::ALL;
  EXPECT_TRUE(repaired(bowl(), parameters).report.complete());
}

TEST(Doubts, AFlatCapIsWhereSomethingStood)
{
  Shape box = cube(12);
  for (Position& p : box.vertices)
    p.z() *= 0.6;
  double top = 0.0;
  for (const Position& p : box.vertices)
    top = std::max(top, p.z());
  const Repaired result = repaired(lacking(box, [top](const Position& p) {
    return p.z() > top - 1e-6 && std::abs(p.x()) < 0.45 && std::abs(p.y()) < 0.45;
  }));
  EXPECT_GT(result.report.new_triangles, 50U);
  EXPECT_TRUE(result.report.complete());
}

/** A twelfth of the area is lost on one side. */
TEST(Doubts, ASurfaceWithHandlesMayHaveLostAnother)
{
  const auto is_lost = [](const Position& p) { return p.x() > 1.1; };
  const Repaired ring = repaired(lacking(torus(96, 48), is_lost));
  EXPECT_EQ(0, topologyOf(ring.triangles()).characteristic);
  ASSERT_EQ(1U, ring.report.doubts.size());
  EXPECT_EQ(DoubtReason::UNSUPPORTED, ring.report.doubts.front().reason);
  EXPECT_GT(ring.report.doubts.front().ratio, 0.05);
  EXPECT_LT(ring.report.doubts.front().ratio, 0.2);
  RepairParameters parameters;
  parameters.greatest_unsupported = 1.0;
  EXPECT_TRUE(repaired(lacking(torus(96, 48), is_lost), parameters).report.complete());
}

/** A sphere without a belt. */
Shape
twoBowls()
{
  return lacking(icosphere(4),
                 [](const Position& p) { return std::abs(p.z()) < 0.25; });
}

/** A junction is joined with so little to spare. */
Repaired
joinedBy(double margin)
{
  RepairParameters parameters;
  parameters.survey.junction.joined_from =
      repaired(twoBowls()).report.junctions.front().evidence.logOdds() - margin;
  return repaired(twoBowls(), parameters);
}

TEST(Doubts, AJunctionThatIsJustJoinedIsOne)
{
  const Repaired result = joinedBy(0.1);
  ASSERT_FALSE(result.report.doubts.empty());
  EXPECT_EQ(DoubtReason::LONG_GAP, result.report.doubts.front().reason);
}

TEST(Doubts, AJunctionNeedsMoreOddsWhereSensorsAreKnown)
{
  RepairReport report;
  report.junctions.resize(1);
  report.junctions.front().verdict = JunctionVerdict::JOINED;
  JunctionEvidence& evidence = report.junctions.front().evidence;
  SurveyParameters parameters;
  parameters.junction.joined_from = evidence.logOdds() - 1.0;
  EXPECT_TRUE(weakJunctions(report, parameters).empty());
  evidence.has_sight = true;
  EXPECT_EQ(1U, weakJunctions(report, parameters).size());
}

TEST(Doubts, AnIslandJoinedToItselfAroundABendIsOneWhereThereAreHandles)
{
  RepairReport report;
  report.after.genus = 1;
  report.junctions.resize(1);
  RepairJunction& junction = report.junctions.front();
  junction.verdict = JunctionVerdict::JOINED;
  junction.evidence.turn = junction.evidence.fold = 1.2;
  junction.evidence.gap_edges = 8.0;
  SurveyParameters parameters;
  parameters.junction.joined_from = junction.evidence.logOdds() - 1.0;
  ASSERT_LT(junction.evidence.logOdds(), 3.6);
  EXPECT_EQ(1U, weakJunctions(report, parameters).size());
  report.after.genus = 0;
  EXPECT_TRUE(weakJunctions(report, parameters).empty());
  report.after.genus = 1;
  junction.islands = {0, 1};
  EXPECT_TRUE(weakJunctions(report, parameters).empty());
}

TEST(Doubts, AJunctionWithOddsToSpareIsNone)
{
  EXPECT_TRUE(joinedBy(2.0).report.complete());
}

/** Between pieces the junctions support what is new. */
TEST(Doubts, SureJunctionsSupportWhatIsNewBetweenIslands)
{
  const Repaired result = repaired(twoBowls());
  EXPECT_EQ(2U, result.report.islands.size());
  EXPECT_TRUE(result.report.complete());
}

} // namespace
} // namespace pcl::repair
