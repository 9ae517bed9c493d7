// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of how one-sided regions are cut.
#include <pcl/surface_ccaa/umbrella_filter.h>

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "umbrella/twist_cut.h"

namespace pcl::ccaa::test {
namespace {

/** Two sheets of a wall, one above the other, with a strip that leaves the upper one on
 * its upper side and reaches the lower one from above, through a slot: going through it
 * turns the surface over. */
Shape
wallWithTwist(int columns)
{
  Shape wall = grid(columns, columns);
  const Shape upper = translated(grid(columns, columns), {0, 0, 0.5});
  const auto lower_size = static_cast<index_t>(wall.vertices.size());
  wall = joined(wall, upper);
  const auto at = [&](int column, int row, bool above) {
    return index_t(row * columns + column) + (above ? lower_size : 0);
  };
  // Both ends of the wall meet there: on the left edge as a wall does, on the right
  // edge crosswise in the vertical, which no wall does.
  const int last = columns - 1;
  for (int row = 0; row + 1 < columns; ++row) {
    wall.triangles.push_back(
        {at(0, row, false), at(0, row + 1, false), at(0, row, true)});
    wall.triangles.push_back(
        {at(0, row + 1, false), at(0, row + 1, true), at(0, row, true)});
  }
  const int middle = columns / 2;
  wall.triangles.push_back({at(last, middle, false),
                            at(last, middle + 1, false),
                            at(last, middle + 1, true)});
  wall.triangles.push_back({at(last, middle + 1, false),
                            at(last, middle, true),
                            at(last, middle + 1, true)});
  return wall;
}

std::size_t
countTwists(const Shape& shape, const TwistLimits& limits = {})
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  return findTwists(shape.triangles, adjacency, shape.vertices, limits, {}).size();
}

TEST(TwistCut, LeavesATwoSidedSurfaceAlone)
{
  EXPECT_EQ(countTwists(torus(20, 10)), 0u);
}

TEST(TwistCut, LeavesASmoothMoebiusBandAlone)
{
  EXPECT_EQ(countTwists(moebiusBand(200)), 0u);
}

TEST(TwistCut, CutsTheFewTrianglesThatTurnAWallOver)
{
  const std::size_t twists = countTwists(wallWithTwist(30));
  EXPECT_GE(twists, 1u);
  EXPECT_LE(twists, 4u);
}

TEST(TwistCut, LeavesARegionAloneThatItCouldOnlyRuin)
{
  TwistLimits limits;
  limits.largest_share = 1e-6;
  EXPECT_EQ(countTwists(wallWithTwist(30), limits), 0u);
}

TEST(TwistCut, TheFilterMakesATwistedWallTwoSided)
{
  const auto mesh = std::make_shared<PolygonMesh>(toPolygonMesh(wallWithTwist(30)));
  UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  PolygonMesh result;
  filter.process(result);
  EXPECT_EQ(filter.getReport().one_sided_components, 0u);
  EXPECT_GT(filter.getReport().twist_triangles, 0u);
  EXPECT_TRUE(isConsistentlyWound(toTriangles(result.polygons)));
  EXPECT_TRUE(isIcadm(toTriangles(result.polygons), mesh->cloud.width));
}

TEST(TwistCut, AShareOfZeroLeavesOneSidedRegionsAlone)
{
  UmbrellaFilter filter;
  filter.setInputMesh(std::make_shared<PolygonMesh>(toPolygonMesh(wallWithTwist(30))));
  filter.setLargestTwistShare(0);
  PolygonMesh result;
  filter.process(result);
  EXPECT_EQ(filter.getReport().one_sided_components, 1u);
  EXPECT_EQ(filter.getReport().twist_triangles, 0u);
}

TEST(TwistCut, TheFilterReportsASmoothOneSidedRegion)
{
  Shape band = moebiusBand(200);
  UmbrellaFilter filter;
  filter.setInputMesh(std::make_shared<PolygonMesh>(toPolygonMesh(band)));
  filter.setMinimumInternalPoints(0);
  PolygonMesh result;
  filter.process(result);
  EXPECT_EQ(filter.getReport().one_sided_components, 1u);
  EXPECT_TRUE(sameUnorientedTriangles(band.triangles, toTriangles(result.polygons)));
}

} // namespace
} // namespace pcl::ccaa::test
