// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair of one region beside that of the whole.
#include <gtest/gtest.h>

#include "render/mesh_parts.h"
#include "repair/decision_proposal.h"
#include "repair_fixture.h"
#include "support/repair_shapes.h"
#include "viewer/local_repair.h"
#include "viewer/mesh_part.h"
#include "viewer_fixture.h"

#include <algorithm>

namespace app_test {
namespace {

using pcl::repair::Decisions;
using pcl::repair::LoopWish;

/** A sphere with a hole at each pole and on the equator. */
pcl::PolygonMesh
threeHoles()
{
  const test::Shape sphere = test::icosphere(5);
  std::vector<std::size_t> lost;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    const auto& place =
        sphere.vertices[static_cast<std::size_t>(sphere.triangles[t][0])];
    if (std::abs(place.z()) > 0.97 || place.x() > 0.98)
      lost.push_back(t);
  }
  return test::toPolygonMesh(
      test::withoutFreeVertices(test::withoutTriangles(sphere, lost)));
}

std::size_t
newTriangles(const app::ViewerRun& run, std::size_t loop)
{
  const auto& of_loop = run.survey.loops[loop].vertices;
  std::set<pcl::index_t> points;
  for (const pcl::index_t vertex : of_loop)
    points.insert(run.survey.model.point_of_vertex[static_cast<std::size_t>(vertex)]);
  for (const pcl::RepairedHole& hole : run.repair.holes)
    if (points.count(hole.point) > 0)
      return hole.triangles;
  return 0;
}

TEST(LocalRepair, ClosesAHoleAsTheWholeRepairDoes)
{
  const app::ViewerRun run = runForViewer(threeHoles());
  const Decisions decisions = proposeDecisions(run.survey, {});
  ASSERT_EQ(3U, decisions.loops.size());
  for (std::size_t loop = 0; loop < 3; ++loop) {
    const app::LocalRepair local = app::repairLocally({}, run.survey, decisions, loop);
    EXPECT_GT(local.triangles, 20U);
    EXPECT_EQ(newTriangles(run, loop), local.triangles) << loop;
    EXPECT_EQ("Closed by " + std::to_string(local.triangles) + " triangles.",
              local.told);
    EXPECT_EQ(local.triangles, local.patches.faces.size());
  }
}

TEST(LocalRepair, JoinsTheLoopsOfAJunctionAsTheWholeRepairDoes)
{
  const app::ViewerRun run = runForViewer(twoCaps());
  const Decisions decisions = proposeDecisions(run.survey, {});
  ASSERT_EQ(1U, decisions.junctions.size());
  const app::LocalRepair local = app::repairLocally({}, run.survey, decisions, 2);
  EXPECT_GT(local.triangles, 500U);
  EXPECT_NEAR(static_cast<double>(run.repair.new_triangles),
              static_cast<double>(local.triangles),
              0.05 * static_cast<double>(local.triangles));
  EXPECT_EQ("Closed by " + std::to_string(local.triangles) + " triangles.", local.told);
}

TEST(LocalRepair, SaysWhyNothingIsDone)
{
  const app::ViewerRun run = runForViewer(twoCaps());
  Decisions decisions = proposeDecisions(run.survey, {});
  decisions.junctions[0].join = false;
  const auto told = [&](std::size_t chosen) {
    const app::LocalRepair local =
        app::repairLocally({}, run.survey, decisions, chosen);
    EXPECT_EQ(0U, local.triangles);
    return local.told;
  };
  EXPECT_EQ("Stays apart, as it is wanted.", told(2));
  EXPECT_EQ("Stays open: what it could be joined to is kept apart.", told(0));
  decisions.loops[0].wish = LoopWish::LEAVE_OPEN;
  EXPECT_EQ("Stays open, as it is wanted.", told(0));
  decisions.junctions[0].join = true;
  EXPECT_EQ("Not joined: loop 0 is to stay open.", told(2));
}

TEST(LocalRepair, KeepsOtherHolesOfThePartOpen)
{
  const app::ViewerRun run = runForViewer(twoCaps());
  Decisions decisions = proposeDecisions(run.survey, {});
  decisions.junctions[0].join = false;
  decisions.loops[0].wish = LoopWish::CLOSE;
  const app::LocalRepair cap = app::repairLocally({}, run.survey, decisions, 0);
  EXPECT_GT(cap.triangles, 100U);
  std::size_t on_other_loop = 0;
  for (const Eigen::Vector3d& place : app::positionsOf(cap.patches))
    for (const Eigen::Vector3d& point : run.survey.loops[1].curve.points)
      on_other_loop += (place - point).norm() < 1e-6 ? 1 : 0;
  EXPECT_EQ(0U, on_other_loop);
}

TEST(MeshPart, IsTheTrianglesWithACornerInTheBox)
{
  const app::ViewerRun run = runForViewer(twoCaps());
  const auto& model = run.survey.model;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.4, -2.0, -2.0),
                                Eigen::Vector3d(0.4, 2.0, 2.0));
  const app::MeshPart part = app::cutPart(model, box);
  std::size_t expected = 0;
  for (const auto& triangle : model.triangles)
    expected += std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t v) {
      return box.contains(model.positions[static_cast<std::size_t>(v)]);
    });
  ASSERT_EQ(expected, part.mesh.polygons.size());
  EXPECT_LT(expected, model.triangles.size());
  EXPECT_TRUE(std::is_sorted(part.point_of.begin(), part.point_of.end()));
  for (std::size_t i = 0; i < part.point_of.size(); ++i)
    EXPECT_EQ(static_cast<pcl::index_t>(i), part.pointFor(part.point_of[i]));
  EXPECT_GT(part.free_points.width, 0U);
  EXPECT_LT(part.free_points.width, model.free_points.size());
}

} // namespace
} // namespace app_test
