// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of islands that are left out.

#include <gtest/gtest.h>

#include "icadm/island_dropping.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <set>

namespace pcl::repair {
namespace {

using namespace ccaa::test;

/** A ball, a small one of as many triangles, a tetrahedron, and a free point. */
Shape
three()
{
  Shape shape = joined(icosphere(2), translated(scaled(icosphere(2), 0.1), {3, 0, 0}));
  shape = joined(shape, translated(tetrahedron(), {0, 5, 0}));
  shape.vertices.emplace_back(0.0, 0.0, 9.0);
  return shape;
}

ReadModel
dropped(const SmallIslands& small)
{
  ReadModel read = readModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(three())), nullptr, {});
  dropIslands(small, {}, read);
  return read;
}

SmallIslands
below(std::size_t triangles, double area, double share)
{
  SmallIslands small;
  small.triangles = triangles;
  small.area = area;
  small.share_of_all_area = share;
  return small;
}

TEST(IslandDropping, KeepsAllBelowNoLimit)
{
  EXPECT_FALSE(SmallIslands().any());
  EXPECT_EQ(3U, dropped({}).model.islands.size());
}

TEST(IslandDropping, CountsTriangles)
{
  const ReadModel read = dropped(below(5, 0.0, 0.0));
  EXPECT_EQ(2U, read.model.islands.size());
  EXPECT_EQ(1U, read.report.dropped_islands);
  EXPECT_EQ(4U, read.report.dropped_triangles);
}

TEST(IslandDropping, MeasuresAreas)
{
  EXPECT_EQ(2U, dropped(below(0, 1.0, 0.0)).model.islands.size());
  EXPECT_EQ(1U, dropped(below(0, 5.0, 0.0)).model.islands.size());
  EXPECT_EQ(2U, dropped(below(0, 0.0, 0.05)).model.islands.size());
}

TEST(IslandDropping, KeepsPointsAndOrderOfWhatStays)
{
  const Shape all = three();
  const ReadModel read = dropped(below(0, 0.5, 0.0)); // the small ball in the middle
  ASSERT_EQ(324U, read.model.triangles.size());
  for (std::size_t t = 0; t < read.model.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto vertex = static_cast<std::size_t>(read.model.triangles[t][c]);
      EXPECT_EQ(all.triangles[t < 320 ? t : t + 320][c],
                read.model.point_of_vertex[vertex]);
    }
}

TEST(IslandDropping, MakesNoFreePoints)
{
  const ReadModel read = dropped(below(5, 0.0, 0.05));
  ASSERT_EQ(1U, read.model.islands.size());
  EXPECT_EQ(1U, read.model.free_points.size()); // that of the input
}

TEST(IslandDropping, HasAProblemWhereNothingIsLeft)
{
  EXPECT_NE("", dropped(below(1000, 0.0, 0.0)).report.problem);
}

} // namespace
} // namespace pcl::repair
