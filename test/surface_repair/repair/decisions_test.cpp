// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of decisions that users make about a repair.

#include "mesh/surface_topology.h"
#include "repair/decision_proposal.h"
#include "support/repair_fixture.h"

#include <cmath>
#include <memory>

namespace pcl::repair {
namespace {

using namespace test;

/** The openings of a barrel: a sphere without its poles, the upper opening the smaller
 * one. */
Shape
barrel()
{
  return inPieces(icosphere(4), [](const Position& p) {
    return p.z() > std::sqrt(1.0 - 0.16) || p.z() < -0.8 ? -1 : 0;
  });
}

/** A sphere without two belts: three islands in a row. */
Shape
threeSlices()
{
  return inPieces(icosphere(4), [](const Position& p) {
    const double height = std::abs(p.z());
    return height > 0.3 && height < 0.55 ? -1 : height < 0.4 ? 0 : p.z() > 0.0 ? 1 : 2;
  });
}

/** The decision about the loop that lies highest. */
LoopDecision&
highest(Decisions& decisions)
{
  return *std::max_element(decisions.loops.begin(),
                           decisions.loops.end(),
                           [](const LoopDecision& a, const LoopDecision& b) {
                             return a.key.center.z() < b.key.center.z();
                           });
}

TEST(Decisions, AreProposedForEachLoopWithItsClass)
{
  const Decisions decisions = proposed(barrel());
  ASSERT_EQ(2U, decisions.loops.size());
  EXPECT_TRUE(decisions.junctions.empty());
  for (const LoopDecision& loop : decisions.loops) {
    EXPECT_EQ(BoundaryClass::HOLE, loop.found);
    EXPECT_EQ(LoopWish::CLOSE, loop.wish);
    EXPECT_EQ(OpenReason::NONE, loop.reason);
    EXPECT_GT(loop.confidence, 0.4);
  }
}

TEST(Decisions, AreProposedForEachPairOfLoopsThatBridgesConnect)
{
  const Decisions decisions = proposed(threeSlices());
  EXPECT_EQ(4U, decisions.loops.size());
  ASSERT_EQ(2U, decisions.junctions.size());
  for (const JunctionDecision& junction : decisions.junctions) {
    EXPECT_LT(junction.first_loop, junction.second_loop);
    EXPECT_GT(junction.bridges, 2U);
    EXPECT_GT(junction.shortest, 0.2);
    for (const std::size_t loop : {junction.first_loop, junction.second_loop}) {
      EXPECT_TRUE(decisions.loops[loop].joined);
      EXPECT_EQ(LoopWish::AUTO, decisions.loops[loop].wish);
    }
  }
}

/** Two slender triangles that meet in a point, and two wedges between them: all force
 * lines lead to these, none from one triangle to the other. */
TEST(Decisions, AreProposedForIslandsThatOnlyTouch)
{
  Shape shape = inPieces(grid(20, 20), [](const Position& p) {
    return std::abs(p.x() - 10.0) < 3.5 && std::abs(p.y() - 10.0) < 3.5 ? -1 : 0;
  });
  const auto center = static_cast<pcl::index_t>(shape.vertices.size());
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{10.0, 10.0},
                                                                   {12.0, 9.9},
                                                                   {12.0, 10.1},
                                                                   {8.0, 10.1},
                                                                   {8.0, 9.9},
                                                                   {10.0, 10.05},
                                                                   {11.9, 10.2},
                                                                   {8.1, 10.2},
                                                                   {10.0, 9.95},
                                                                   {8.1, 9.8},
                                                                   {11.9, 9.8}})
    shape.vertices.emplace_back(x, y, 0.0);
  shape.triangles.push_back({center, center + 1, center + 2});
  shape.triangles.push_back({center, center + 3, center + 4});
  shape.triangles.push_back({center + 5, center + 6, center + 7});
  shape.triangles.push_back({center + 8, center + 9, center + 10});
  const Decisions decisions = proposed(shape);
  const auto touching = std::find_if(
      decisions.junctions.begin(), decisions.junctions.end(), [](const auto& junction) {
        return junction.bridges > 0 && junction.shortest == 0.0;
      });
  ASSERT_NE(decisions.junctions.end(), touching);
  EXPECT_TRUE(touching->join);
  EXPECT_EQ(1.0, touching->confidence);
}

TEST(Decisions, OfTheFacadeAreThoseOfTheSurvey)
{
  ForceLineHoleRepair repair;
  EXPECT_TRUE(repair.proposeDecisions().loops.empty()) << "no mesh";
  for (const Shape& shape : {barrel(), threeSlices()}) {
    const Decisions expected = proposed(shape);
    repair.setInputMesh(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)));
    const Decisions decisions = repair.proposeDecisions();
    EXPECT_EQ(expected.mesh.checksum, decisions.mesh.checksum);
    EXPECT_EQ(expected.junctions.size(), decisions.junctions.size());
    ASSERT_EQ(expected.loops.size(), decisions.loops.size());
    for (std::size_t k = 0; k < expected.loops.size(); ++k) {
      EXPECT_EQ(expected.loops[k].key.point, decisions.loops[k].key.point);
      EXPECT_EQ(expected.loops[k].wish, decisions.loops[k].wish);
    }
  }
}

TEST(Decisions, LeaveABorderOpenUnlessAllIsToBeClosed)
{
  const Shape sheet = terrain(20, 20, 1.0);
  EXPECT_EQ(LoopWish::LEAVE_OPEN, proposed(sheet).loops.at(0).wish);
  RepairParameters all;
  all.filling.close = CloseChoice::ALL;
  EXPECT_EQ(LoopWish::CLOSE, proposed(sheet, all).loops.at(0).wish);
}

TEST(Decisions, AsProposedChangeNothing)
{
  for (const Shape& shape : {barrel(), threeSlices(), terrain(20, 20, 1.0)}) {
    const Repaired plain = repaired(shape);
    const Repaired result = decided(shape, proposed(shape));
    EXPECT_EQ(plain.output.cloud.data, result.output.cloud.data);
    EXPECT_EQ(plain.triangles(), result.triangles());
    EXPECT_EQ(plain.report.shortfalls, result.report.shortfalls);
  }
}

TEST(Decisions, LeaveALoopOpenWithoutAShortfall)
{
  Decisions decisions = proposed(barrel());
  highest(decisions).wish = LoopWish::LEAVE_OPEN;
  const Repaired result = decided(barrel(), decisions);
  EXPECT_EQ(1U, topologyOf(result.triangles()).borders);
  EXPECT_TRUE(result.report.complete());
  expectNothingWorse(result, barrel().triangles);
}

TEST(Decisions, CloseAnOuterBorder)
{
  const Shape sheet =
      inPieces(icosphere(4), [](const Position& p) { return p.z() < 0.3 ? -1 : 0; });
  Decisions decisions = proposed(sheet);
  ASSERT_EQ(BoundaryClass::OUTER_BORDER, decisions.loops.at(0).found);
  decisions.loops[0].wish = LoopWish::CLOSE;
  EXPECT_EQ(0U, countBoundaryEdges(decided(sheet, decisions).triangles()));
}

TEST(Decisions, KeepTwoIslandsApart)
{
  Decisions decisions = proposed(threeSlices());
  ASSERT_EQ(2U, decisions.junctions.size());
  decisions.junctions[0].join = false;
  const Repaired result = decided(threeSlices(), decisions);
  EXPECT_EQ(2U, topologyOf(result.triangles()).components);
  expectNothingWorse(result, threeSlices().triangles);
}

TEST(Decisions, JoinWhatEvidenceSpeaksAgainst)
{
  RepairParameters parameters;
  parameters.survey.junction.joined_from = 1e9; // nothing is believed
  Decisions decisions = proposed(threeSlices(), parameters);
  ASSERT_EQ(3U, topologyOf(repaired(threeSlices(), parameters).triangles()).components);
  ASSERT_LE(2U, decisions.junctions.size());
  for (JunctionDecision& junction : decisions.junctions) {
    EXPECT_FALSE(junction.join);
    junction.join = true;
  }
  parameters.survey.decisions = std::make_shared<const Decisions>(decisions);
  const Repaired result = repaired(threeSlices(), parameters);
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  expectNothingWorse(result, threeSlices().triangles);
}

TEST(Decisions, ALoopThatIsToBeLeftOpenIsNotJoinedEither)
{
  Decisions decisions = proposed(threeSlices());
  highest(decisions).wish = LoopWish::LEAVE_OPEN;
  const Repaired result = decided(threeSlices(), decisions);
  EXPECT_EQ(2U, topologyOf(result.triangles()).components);
  EXPECT_GE(topologyOf(result.triangles()).borders, 1U);
}

TEST(Decisions, AreKeptInAnotherProposal)
{
  Decisions decisions = proposed(threeSlices());
  decisions.junctions[1].join = false;
  highest(decisions).cap = Cap::FLAT;
  RepairParameters parameters;
  parameters.survey.decisions = std::make_shared<const Decisions>(decisions);
  Decisions again = proposed(threeSlices(), parameters);
  ASSERT_EQ(2U, again.junctions.size());
  EXPECT_TRUE(again.junctions[0].join);
  EXPECT_FALSE(again.junctions[1].join);
  EXPECT_EQ(Cap::FLAT, highest(again).cap);
}

/** PCL's errors are expected here and would only hide others. */
class RefusedDecisions : public ::testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }

  static std::string
  problemOf(const Repaired& result)
  {
    EXPECT_TRUE(result.output.polygons.empty());
    return result.report.reading.problem;
  }
};

TEST_F(RefusedDecisions, AboutAMeshWithOtherCounts)
{
  EXPECT_NE("", problemOf(decided(threeSlices(), proposed(barrel()))));
}

TEST_F(RefusedDecisions, AboutAMeshWithOtherCoordinates)
{
  Shape moved = barrel();
  moved.vertices[7].x() += 1e-3;
  EXPECT_NE("", problemOf(decided(moved, proposed(barrel()))));
}

TEST_F(RefusedDecisions, AboutALoopThatIsNotThere)
{
  Decisions decisions = proposed(barrel());
  ++decisions.loops[0].key.edges;
  EXPECT_NE("", problemOf(decided(barrel(), decisions)));
}

TEST_F(RefusedDecisions, AboutAJunctionOfALoopThatIsNotListed)
{
  Decisions decisions = proposed(threeSlices());
  decisions.junctions[0].second_loop = 17;
  EXPECT_NE("", problemOf(decided(threeSlices(), decisions)));
}

} // namespace
} // namespace pcl::repair
