// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the proof that what is written is a manifold.

#include <gtest/gtest.h>

#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"
#include "verification/last_check.h"

namespace pcl::repair::test {
namespace {

/** A sheet with two square holes, and patches of three more vertices that the tests
 * choose. */
class LastCheckOfASheet : public ::testing::Test {
protected:
  LastCheckOfASheet()
  {
    const Shape sheet = grid(8, 4);
    const auto is_hole = [](std::size_t t) { return t / 2 == 8 || t / 2 == 12; };
    Triangles left;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
      (is_hole(t) ? squares_ : left).push_back(sheet.triangles[t]);
    repaired_.model.triangles = left;
    repaired_.model.positions = sheet.vertices;
    for (int k = 0; k < 3; ++k)
      repaired_.model.positions.push_back(Position(20.0, k, k * k));
    for (std::size_t v = 0; v < repaired_.model.positions.size(); ++v)
      repaired_.model.point_of_vertex.push_back(
          v < sheet.vertices.size() ? static_cast<pcl::index_t>(v) : pcl::UNAVAILABLE);
    repaired_.input_vertices = sheet.vertices.size();
    repaired_.input_triangles = left.size();
    report_.hole_of.assign(left.size(), NONE);
    report_.origins.assign(left.size(), TriangleOrigin::INPUT);
  }

  void
  addHole(const Triangles& triangles)
  {
    repaired_.model.triangles.insert(
        repaired_.model.triangles.end(), triangles.begin(), triangles.end());
    report_.hole_of.insert(
        report_.hole_of.end(), triangles.size(), report_.holes.size());
    report_.origins.insert(
        report_.origins.end(), triangles.size(), TriangleOrigin::MINIMUM_WEIGHT);
    RepairedHole hole;
    hole.filling = "minimum weight";
    hole.triangles = triangles.size();
    report_.holes.push_back(hole);
  }

  Triangles
  square(std::size_t hole) const
  {
    return {squares_[2 * hole], squares_[2 * hole + 1]};
  }

  bool
  prove()
  {
    IncompleteModel& model = repaired_.model;
    model.adjacency.build(model.triangles, model.positions.size());
    return proveManifold({}, repaired_, report_);
  }

  /** The first hole stays closed, the second one is open again. */
  void
  expectOnlyTheSecondIsTakenBack()
  {
    EXPECT_TRUE(prove());
    const IncompleteModel& model = repaired_.model;
    EXPECT_TRUE(isIcadm(model.triangles, model.positions.size()));
    EXPECT_TRUE(ccaa::test::isConsistentlyWound(model.triangles));
    EXPECT_EQ(repaired_.input_triangles + 2, model.triangles.size());
    EXPECT_EQ(OpenReason::NONE, report_.holes[0].open);
    EXPECT_EQ(OpenReason::NOT_MANIFOLD, report_.holes[1].open);
    EXPECT_EQ(1U, report_.shortfalls);
    EXPECT_EQ(model.triangles.size(), report_.hole_of.size());
    EXPECT_EQ(model.triangles.size(), report_.origins.size());
  }

  RepairedModel repaired_;
  RepairReport report_;

private:
  Triangles squares_;
};

TEST_F(LastCheckOfASheet, LeavesAManifoldAsItIs)
{
  addHole(square(0));
  addHole(square(1));
  const Triangles before = repaired_.model.triangles;
  EXPECT_TRUE(prove());
  EXPECT_EQ(before, repaired_.model.triangles);
  EXPECT_EQ(0U, report_.shortfalls);
  EXPECT_EQ(1U, report_.after.boundary_loops);
  EXPECT_EQ(1, report_.after.euler_characteristic);
}

TEST_F(LastCheckOfASheet, TakesBackWhatGivesAnEdgeAThirdTriangle)
{
  addHole(square(0));
  const Triangle& inner = repaired_.model.triangles.front();
  Triangles patch = square(1);
  patch.push_back({inner[2], inner[1], 32});
  addHole(patch);
  expectOnlyTheSecondIsTakenBack();
}

TEST_F(LastCheckOfASheet, TakesBackWhatTouchesInAPointOnly)
{
  addHole(square(0));
  addHole({{29, 32, 33}});
  expectOnlyTheSecondIsTakenBack();
}

TEST_F(LastCheckOfASheet, TakesBackWhatIsWoundTheOtherWay)
{
  addHole(square(0));
  addHole(reversed(square(1)));
  expectOnlyTheSecondIsTakenBack();
}

TEST_F(LastCheckOfASheet, TakesTheVerticesOfAPatchBackToo)
{
  addHole({{0, 32, 33}});
  addHole({{0, 33, 34}});
  EXPECT_TRUE(prove());
  EXPECT_EQ(2U, report_.shortfalls);
  EXPECT_EQ(repaired_.input_vertices, repaired_.model.positions.size());
}

TEST_F(LastCheckOfASheet, TakesBackTheHoleThatWasClosedLastAtAPlace)
{
  addHole(square(0));
  addHole({{9, 32, 33}}); // a corner of the first hole
  expectOnlyTheSecondIsTakenBack();
}

TEST_F(LastCheckOfASheet, CutsTheInputWhereItAloneIsAtFaultAndKeepsIt)
{
  const Triangle inner = repaired_.model.triangles.front();
  repaired_.model.triangles.push_back({inner[2], inner[1], 32});
  report_.hole_of.push_back(NONE);
  report_.origins.push_back(TriangleOrigin::INPUT);
  repaired_.input_triangles = repaired_.model.triangles.size();
  EXPECT_TRUE(prove());
  EXPECT_EQ(repaired_.input_triangles, repaired_.model.triangles.size());
  EXPECT_TRUE(isIcadm(repaired_.model.triangles, repaired_.model.positions.size()));
}

} // namespace
} // namespace pcl::repair::test
