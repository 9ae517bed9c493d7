// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a repair goes by what it is told about the outer side.
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/completion_shapes.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/single_view.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;

constexpr double LEAST_SHARE = 0.97;

/** A view as islands that show the sensor their front. */
PolygonMesh::Ptr
seenIslandsOf(const SingleView& view)
{
  ConsecutiveReconstruction<PointXYZ> chain;
  chain.setInputCloud(toCloud(view.points));
  chain.setViewpoint(view.sensor);
  const auto mesh = make_shared<PolygonMesh>();
  chain.reconstruct(*mesh);
  return mesh;
}

/** A view as islands that know of no sensor, every second one turned. */
PolygonMesh::Ptr
islandsOf(const SingleView& view)
{
  ConsecutiveReconstruction<PointXYZ> chain;
  chain.setInputCloud(toCloud(view.points));
  const auto mesh = make_shared<PolygonMesh>();
  chain.reconstruct(*mesh);
  Triangles triangles;
  for (const Vertices& polygon : mesh->polygons)
    triangles.push_back(
        {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
  triangles = withEverySecondPieceReversed(triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh->polygons[t].vertices.assign(triangles[t].begin(), triangles[t].end());
  return mesh;
}

/** Share of the given triangles that faces a place after the repair. */
double
facingAfter(ForceLineHoleRepair& repair,
            const SingleView& view,
            const PolygonMesh::Ptr& mesh)
{
  PolygonMesh repaired;
  repair.setInputMesh(mesh);
  repair.process(repaired);
  repaired.polygons.resize(repair.getReport().input_triangles);
  return facingShare(repaired.polygons, view.points, view.sensor);
}

TEST(ToldSides, GivenTrianglesFaceTheViewpointAfterARepair)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SingleView view = singleView(seed, 50);
    ForceLineHoleRepair repair;
    repair.setViewpoint(view.sensor);
    EXPECT_GE(facingAfter(repair, view, islandsOf(view)), LEAST_SHARE) << seed;
    // Slivers at silhouettes, whose own triangles disagree, are left to other rules.
    EXPECT_EQ(repair.getReport().islands[0].side.rule, SideRule::TOLD_VIEWPOINT);
  }
}

TEST(ToldSides, NewTrianglesFaceTheViewpointToo)
{
  const SingleView view = singleView(5);
  ForceLineHoleRepair repair;
  repair.setInputMesh(seenIslandsOf(view));
  repair.setViewpoint(view.sensor);
  PolygonMesh repaired;
  repair.process(repaired);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(repaired.cloud, cloud);
  Positions points;
  for (const pcl::PointXYZ& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  EXPECT_GE(facingShare(repaired.polygons, points, view.sensor), LEAST_SHARE);
}

TEST(ToldSides, AJumpInDepthIsClosedIfTheUserWantsAllClosed)
{
  const auto mesh =
      make_shared<PolygonMesh>(toPolygonMesh(repair::test::brokenCliff(10.0)));
  for (const bool all : {false, true}) {
    ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setViewpoint(Position(12.0, 12.0, 1000.0));
    repair.setClose(all ? CloseChoice::ALL : CloseChoice::HOLES);
    PolygonMesh repaired;
    repair.process(repaired);
    const auto& holes = repair.getReport().holes;
    const auto left = std::count_if(holes.begin(), holes.end(), [](const auto& hole) {
      return hole.open == OpenReason::DEPTH_JUMP;
    });
    EXPECT_EQ(left, all ? 0 : 1);
  }
}

TEST(ToldSides, GivenTrianglesFaceTheOriginAfterARepairThatMayTakeIt)
{
  const SingleView view = inSensorFrame(singleView(2, 50));
  ForceLineHoleRepair repair;
  repair.setOriginAsViewpoint(true);
  EXPECT_GE(facingAfter(repair, view, islandsOf(view)), LEAST_SHARE);
  EXPECT_EQ(repair.getReport().islands[0].side.rule, SideRule::ORIGIN);
}

TEST(ToldSides, ATerrainLooksUpThatIsToldUp)
{
  const Shape ground = terrain(12, 12);
  const Shape other = translated(terrain(9, 9), {14.0, 0.0, 0.0});
  const Shape both = joined(ground, {other.vertices, reversed(other.triangles)});
  ForceLineHoleRepair repair;
  repair.setUp(Eigen::Vector3d(0.0, 0.0, -2.0));
  repair.setJoinIslands(false);
  SingleView from_below{both.vertices, {8.0, 5.0, -1e6}};
  EXPECT_EQ(
      facingAfter(repair, from_below, make_shared<PolygonMesh>(toPolygonMesh(both))),
      1.0);
  for (const RepairedIsland& island : repair.getReport().islands)
    EXPECT_EQ(island.side.rule, SideRule::UP);
}

} // namespace
} // namespace pcl::repair
