// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of reading and writing PCL polygons.
#include <gtest/gtest.h>

#include "mesh/polygon_access.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <limits>

namespace pcl::ccaa::test {
namespace {

using Polygons = std::vector<pcl::Vertices>;

pcl::Vertices
polygon(const std::vector<pcl::index_t>& corners)
{
  pcl::Vertices result;
  result.vertices.assign(corners.begin(), corners.end());
  return result;
}

/** \brief The triangles with their corners as point indices again. */
Triangles
asPoints(const PolygonTriangles& mesh)
{
  Triangles triangles = mesh.triangles;
  for (auto& triangle : triangles)
    for (auto& corner : triangle)
      corner = mesh.point_of_vertex.at(static_cast<std::size_t>(corner));
  return triangles;
}

TEST(PolygonAccess, NumbersVerticesByFirstAppearance)
{
  const Positions points(8, Position::Zero());
  const auto mesh =
      readPolygons(Polygons{polygon({5, 2, 7}), polygon({2, 1, 5})}, points, {});
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 0}}));
  EXPECT_EQ(mesh.point_of_vertex, (std::vector<pcl::index_t>{5, 2, 7, 1}));
  EXPECT_EQ(mesh.invalid_polygons, 0u);
}

TEST(PolygonAccess, SplitsLargePolygonsIntoFans)
{
  const Positions points(9, Position::Zero());
  const auto mesh =
      readPolygons(Polygons{polygon({4, 3, 2, 1, 0}), polygon({6, 7, 8})}, points, {});
  EXPECT_EQ(asPoints(mesh), (Triangles{{4, 3, 2}, {4, 2, 1}, {4, 1, 0}, {6, 7, 8}}));
}

TEST(PolygonAccess, MakesFansWithoutALookAtTheirCorners)
{
  EXPECT_EQ(fanTriangles(
                Polygons{polygon({4, 3, 9, 1}), polygon({0, 1}), polygon({6, -1, 6})}),
            (Triangles{{4, 3, 9}, {4, 9, 1}, {6, -1, 6}}));
}

TEST(PolygonAccess, LeavesOutInvalidPolygons)
{
  Positions points(6, Position::Zero());
  points[5].y() = std::numeric_limits<double>::quiet_NaN();
  const Polygons polygons{polygon({}),
                          polygon({0}),
                          polygon({0, 1}),
                          polygon({0, 1, 6}),
                          polygon({-1, 1, 2}),
                          polygon({0, 1, 1}),
                          polygon({0, 1, 2, 3, 0}),
                          polygon({3, 4, 5}),
                          polygon({3, 4, 1, 5}),
                          polygon({0, 1, 2})};
  const auto mesh = readPolygons(polygons, points, {});
  EXPECT_EQ(asPoints(mesh), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(mesh.invalid_polygons, 9u);
}

TEST(PolygonAccess, ReadsTheSameWithAnyNumberOfThreads)
{
  for (const auto& shape : {torus(300, 200), shuffled(torus(300, 200), 4)}) {
    auto polygons = toPolygons(shape.triangles);
    polygons[1000].vertices[1] = -7;
    const auto one = readPolygons(polygons, shape.vertices, {});
    for (const int threads : {2, 7}) {
      LoopContext context;
      context.threads = threads;
      const auto many = readPolygons(polygons, shape.vertices, context);
      EXPECT_EQ(one.triangles, many.triangles);
      EXPECT_EQ(one.point_of_vertex, many.point_of_vertex);
      EXPECT_EQ(one.invalid_polygons, many.invalid_polygons);
    }
  }
}

TEST(PolygonAccess, ReadsRowsOfAnArrayAsPolygons)
{
  const Positions points(8, Position::Zero());
  const std::vector<pcl::index_t> rows{5, 2, 7, 1, 2, 1, 1, 5, 0, 1, 2, 8, 4, 3, 2, 1};
  Polygons polygons;
  for (auto row = rows.begin(); row != rows.end(); row += 4)
    polygons.push_back(polygon({row, row + 4}));
  const auto expected = readPolygons(polygons, points, {});
  const auto mesh = readPolygons({rows.data(), 4, 4}, points, {});
  EXPECT_EQ(asPoints(mesh), (Triangles{{5, 2, 7}, {5, 7, 1}, {4, 3, 2}, {4, 2, 1}}));
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(mesh.point_of_vertex, expected.point_of_vertex);
  EXPECT_EQ(mesh.invalid_polygons, 2u);
  EXPECT_EQ(fanTriangles({rows.data(), 4, 4}), fanTriangles(polygons));
}

TEST(PolygonAccess, WritesWhatItHasRead)
{
  const auto shape = shuffled(icosphere(2), 9);
  const auto mesh = readPolygons(toPolygons(shape.triangles), shape.vertices, {});
  Polygons polygons(7, polygon({1, 2, 3, 4}));
  handOut(mesh.triangles, mesh.point_of_vertex, {}, nullptr, polygons);
  EXPECT_EQ(toTriangles(polygons), shape.triangles);
  TriangleHandoff handoff;
  handOut(mesh.triangles, mesh.point_of_vertex, {}, &handoff, polygons);
  EXPECT_EQ(handoff.made, shape.triangles);
}

TEST(PolygonAccess, KeepsLiveTrianglesInOrder)
{
  const Triangles triangles{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  EXPECT_EQ(liveTriangles(triangles, {1, 0, 1}, {}), (Triangles{{0, 1, 2}, {2, 3, 4}}));
  EXPECT_TRUE(liveTriangles({}, {}, {}).empty());
}

} // namespace
} // namespace pcl::ccaa::test
