// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of reading any mesh as an incomplete model.
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include "icadm/model_assembly.h"
#include "read_shapes.h"
#include "support/clouds.h"
#include "support/raw_clouds.h"
#include "support/shared_data.h"

#include <limits>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::meshOf;
using test::pointTriangles;
using test::read;

Direction
normalOf(const IncompleteModel& model, std::size_t vertex)
{
  return externalNormals(model.triangles, model.positions, {})[vertex];
}

TEST(ModelReading, ManifoldInputIsTakenTriangleForTriangle)
{
  const Shape shape = shuffled(cylinder(20, 10), 3);
  const ReadModel result = read(shape);
  EXPECT_EQ(shape.triangles, pointTriangles(result.model));
  EXPECT_EQ("", result.report.problem);
}

TEST(ModelReading, InwardWindingIsTakenAsItIs)
{
  Shape shape = icosphere(2);
  shape.triangles = reversed(shape.triangles);
  const ReadModel result = read(shape);
  EXPECT_EQ(shape.triangles, pointTriangles(result.model));
  EXPECT_LT(normalOf(result.model, 0).dot(result.model.positions[0]), -0.9);
}

TEST(ModelReading, IslandsAreCountedByLowestTriangle)
{
  const Shape shape =
      joined(icosphere(2, 2.0), translated(grid(4, 3), Position(9, 0, 0)));
  const IncompleteModel model = read(shape).model;
  ASSERT_EQ(2u, model.islands.size());
  EXPECT_TRUE(model.islands[0].closed);
  EXPECT_FALSE(model.islands[1].closed);
  EXPECT_EQ(320, model.islands[1].first_triangle);
  EXPECT_EQ(12u, model.islands[1].triangles);
  EXPECT_DOUBLE_EQ(6.0, model.islands[1].area);
  EXPECT_EQ(Position(3, 2, 0), Position(model.islands[1].box.sizes()));
}

TEST(ModelReading, UnusedPointsAreFreePointsInCloudOrder)
{
  Shape shape = grid(3, 3);
  shape.vertices.insert(shape.vertices.begin(), Position(7, 7, 7));
  for (Triangle& triangle : shape.triangles)
    for (pcl::index_t& corner : triangle)
      ++corner;
  shape.vertices.emplace_back(8, 8, 8);
  const IncompleteModel model = read(shape).model;
  EXPECT_EQ((std::vector<pcl::index_t>{0, 10}), model.point_of_free_point);
  EXPECT_EQ(Position(8, 8, 8), model.free_points[1]);
}

TEST(ModelReading, ASeparateCloudOfFreePointsFollows)
{
  pcl::PCLPointCloud2 cloud = toPolygonMesh(Shape{{{5, 6, 7}}, {}}).cloud;
  const IncompleteModel model =
      readModel(meshOf(grid(3, 3)), &cloud, ccaa::LoopContext()).model;
  ASSERT_EQ(1u, model.free_points.size());
  EXPECT_EQ(Position(5, 6, 7), model.free_points[0]);
  EXPECT_EQ(pcl::UNAVAILABLE, model.point_of_free_point[0]);
}

TEST(ModelReading, NonFinitePointsAreCountedAndNoFreePoints)
{
  Shape shape = grid(3, 3);
  shape.vertices.push_back(
      Position::Constant(std::numeric_limits<double>::quiet_NaN()));
  const ReadModel result = read(shape);
  EXPECT_EQ(1u, result.report.non_finite_points);
  EXPECT_TRUE(result.model.free_points.empty());
}

TEST(ModelReading, InvalidPolygonsAreLeftOutAndCounted)
{
  auto mesh = meshOf(grid(4, 4));
  const auto good = mesh->polygons.size();
  mesh->polygons.resize(good + 3);
  mesh->polygons[good].vertices = {0, 1, 1};
  mesh->polygons[good + 1].vertices = {0, 1, 99};
  mesh->polygons[good + 2].vertices = {0, 1};
  const ReadModel result = read(mesh);
  EXPECT_EQ(3u, result.report.invalid_polygons);
  EXPECT_EQ(good, result.model.triangles.size());
}

TEST(ModelReading, QuadsBecomeTwoTriangles)
{
  auto mesh = meshOf(grid(2, 2));
  mesh->polygons.resize(1);
  mesh->polygons[0].vertices = {0, 1, 3, 2};
  EXPECT_EQ(2u, read(mesh).model.triangles.size());
}

/** \brief Meshes that are no ICADM. */
std::vector<Shape>
faultyShapes()
{
  Shape overfull = icosphere(2);
  overfull.vertices.emplace_back(3, 3, 3);
  overfull.triangles.push_back(
      {overfull.triangles[0][0],
       overfull.triangles[0][1],
       static_cast<pcl::index_t>(overfull.vertices.size()) - 1});
  Shape mixed = icosphere(2);
  mixed.triangles = randomlyReversed(mixed.triangles, 1);
  return {joined(bowTie(), translated(grid(4, 4), Position(5, 5, 5))),
          joined(threeOnEdge(), icosphere(1)),
          joined(twoFansAtApex(), icosphere(1)),
          overfull,
          mixed};
}

TEST(ModelReading, WhateverComesInAManifoldComesOut)
{
  for (const Shape& shape : faultyShapes()) {
    const ReadModel result = read(shape);
    EXPECT_TRUE(isIcadm(result.model.triangles, result.model.positions.size()));
    EXPECT_TRUE(ccaa::test::isConsistentlyWound(result.model.triangles));
    EXPECT_TRUE(sameUnorientedTriangles(shape.triangles, pointTriangles(result.model)));
  }
}

TEST(ModelReading, TheAdjacencyIsThatOfTheTrianglesAsTheyAreWoundNow)
{
  Shape open = icosphere(3);
  open.triangles.resize(open.triangles.size() - 40);
  open.triangles = randomlyReversed(open.triangles, 2);
  std::vector<Shape> shapes = faultyShapes();
  shapes.push_back(open);
  for (const Shape& shape : shapes) {
    const IncompleteModel model = read(shape).model;
    ccaa::TriangleAdjacency anew;
    anew.build(model.triangles, model.positions.size());
    for (std::size_t t = 0; t < model.triangles.size(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        ASSERT_EQ(anew.across(pcl::index_t(t), corner),
                  model.adjacency.across(pcl::index_t(t), corner));
  }
}

TEST(ModelReading, AnIslandKeepsTheSideMostOfItWasGiven)
{
  Shape shape = icosphere(2);
  shape.triangles = reversed(shape.triangles);
  std::swap(shape.triangles[7][1], shape.triangles[7][2]);
  const ReadModel result = read(shape);
  EXPECT_EQ(1u, result.report.reversed_triangles);
  EXPECT_LT(normalOf(result.model, 0).dot(result.model.positions[0]), -0.9);
}

TEST(ModelReading, AnIslandWoundAtRandomIsWoundOutward)
{
  Shape shape = icosphere(2);
  shape.triangles = randomlyReversed(shape.triangles, 1);
  const ReadModel result = read(shape);
  EXPECT_GT(normalOf(result.model, 0).dot(result.model.positions[0]), 0.9);
  EXPECT_GT(result.report.reversed_triangles, 100u);
}

TEST(ModelReading, PointsAtThePlaceOfAVertexAreNoFreePoints)
{
  Shape shape = grid(4, 4);
  shape.vertices.push_back(shape.vertices[5]);
  shape.vertices.emplace_back(1.5, 1.5, 0.0);
  const ReadModel result = read(shape);
  EXPECT_EQ(1u, result.report.points_on_vertices);
  EXPECT_EQ((std::vector<pcl::index_t>{17}), result.model.point_of_free_point);
}

TEST(ModelReading, OfAWholeCloudOnlyPointsBesideTheMeshAreFree)
{
  const Shape shape = grid(5, 5);
  Shape cloud{shape.vertices, {}};
  cloud.vertices.emplace_back(0.5, 0.5, 1.0);
  cloud.vertices.insert(
      cloud.vertices.end(), shape.vertices.begin(), shape.vertices.end());
  const pcl::PolygonMesh points = toPolygonMesh(cloud);
  const ReadModel result =
      readModel(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)),
                &points.cloud,
                ccaa::LoopContext());
  EXPECT_EQ(50u, result.report.points_on_vertices);
  ASSERT_EQ(1u, result.model.free_points.size());
  EXPECT_EQ(Position(0.5, 0.5, 1.0), result.model.free_points[0]);
}

TEST(ModelReading, SmallRegionsStay)
{
  const Shape shape = joined(
      bowTie(), joined(tetrahedron(), translated(grid(2, 2), Position(3, 3, 3))));
  EXPECT_EQ(4u, read(shape).model.islands.size()); // the bow-tie is two
}

TEST(ModelReading, OneSidedIslandsAreFlaggedAndKept)
{
  const Shape band = moebiusBand(60);
  const IncompleteModel model =
      read(joined(band, translated(icosphere(1), Position(9, 9, 9)))).model;
  ASSERT_EQ(2u, model.islands.size());
  EXPECT_TRUE(model.islands[0].one_sided);
  EXPECT_EQ(band.triangles.size(), model.islands[0].triangles);
  EXPECT_FALSE(model.islands[1].one_sided);
}

TEST(ModelReading, NothingToReadIsAProblem)
{
  EXPECT_NE("", read(pcl::PolygonMesh::ConstPtr()).report.problem);
  EXPECT_NE("", read(Shape()).report.problem);
  EXPECT_NE("", read(Shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}).report.problem);
  EXPECT_NE("", read(Shape{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}).report.problem);
}

TEST(ModelReading, UnreadableCloudsAreAProblem)
{
  auto mesh = meshOf(grid(3, 3));
  pcl::PCLPointCloud2 bad = mesh->cloud;
  bad.data.pop_back();
  EXPECT_NE("", readModel(mesh, &bad, ccaa::LoopContext()).report.problem);
  mesh->cloud = bad;
  EXPECT_NE("", read(mesh).report.problem);
}

TEST(ModelReading, CancellingLeavesNothingButAProblem)
{
  for (const Shape& shape : {icosphere(3), faultyShapes().back()}) {
    ccaa::RunControl control([](const std::string&, double) { return false; });
    const ReadModel result = readModel(
        meshOf(shape), nullptr, ccaa::LoopContext{2, &control, "reading", 64});
    EXPECT_NE("", result.report.problem);
    EXPECT_TRUE(result.model.triangles.empty());
  }
}

TEST(ModelReading, NormalsAndViewpointsComeFromTheCloud)
{
  auto mesh = meshOf(grid(2, 2));
  FieldList fields = xyzFields();
  for (const char* name : {"normal_x", "normal_y", "normal_z", "vp_x", "vp_y", "vp_z"})
    fields.emplace_back(name, pcl::PCLPointField::FLOAT32);
  mesh->cloud = rawCloud(fields, 4);
  setValue(mesh->cloud, 1, "x", 1.f);
  setValue(mesh->cloud, 2, "y", 1.f);
  setValue(mesh->cloud, 3, "normal_z", 2.f);
  setValue(mesh->cloud, 3, "vp_x", 5.f);
  const IncompleteModel model = read(mesh).model;
  std::size_t vertex = 0;
  while (model.point_of_vertex[vertex] != 3)
    ++vertex;
  EXPECT_EQ(Position(0, 0, 2), model.given_normals[vertex]);
  EXPECT_EQ(Position(5, 0, 0), model.viewpoints[vertex]);
}

TEST(ModelReading, IsTheSameForAnyNumberOfThreads)
{
  const auto mesh = meshOf(shuffled(faultyShapes()[3], 5));
  const ReadModel expected = read(mesh);
  const ReadModel result =
      readModel(mesh, nullptr, ccaa::LoopContext{4, nullptr, "", 100});
  EXPECT_EQ(expected.model.triangles, result.model.triangles);
  EXPECT_EQ(expected.model.normals, result.model.normals);
}

TEST(ModelReading, TheBunnyIsTakenAsItIs)
{
  const std::string path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  ASSERT_GE(pcl::io::loadPLYFile(path, *mesh), 0);
  const ReadModel result = read(mesh);
  EXPECT_EQ(0u, result.report.separated_fans);
  EXPECT_EQ(69451u, result.model.triangles.size());
  EXPECT_EQ(1113u, result.model.free_points.size());
  EXPECT_EQ(1u, result.model.islands.size());
}

} // namespace
} // namespace pcl::repair
