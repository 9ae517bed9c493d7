// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes in map coordinates go through the classes as
// doubles.
#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/conversions.h>

#include "support/clouds.h"
#include "support/repair_fixture.h"

namespace pcl::repair::test {
namespace {

/** The shift of all models here. */
const Position SHIFT(596648, 5420315, 251);

pcl::PolygonMesh
doubleMesh(const Shape& shape, const Position& place)
{
  pcl::PolygonMesh mesh = toPolygonMesh(shape);
  mesh.cloud = toDoubleCloud(shifted(shape.vertices, place));
  return mesh;
}

/** A surface in pieces around the origin that stays exact elsewhere. */
const DamagedModel&
sample()
{
  static const DamagedModel model = [] {
    DamagedModel made = casesInPieces(1).front().make();
    made.damaged.vertices = onGrid(made.damaged.vertices);
    made.free_points = onGrid(made.truth.vertices);
    return made;
  }();
  return model;
}

const Repaired&
here()
{
  static const Repaired result = repaired(doubleMesh(sample().damaged, {0, 0, 0}));
  return result;
}

const Repaired&
onTheMap()
{
  static const Repaired result = repaired(doubleMesh(sample().damaged, SHIFT));
  return result;
}

/** The appended points are those of the other result, and elsewhere. */
void
expectSamePlaces(const Repaired& near, const Repaired& far, const Position& place)
{
  const auto before = ccaa::positionView(near.output.cloud);
  const auto after = ccaa::positionView(far.output.cloud);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((after[i] - before[i] - place).norm(), 1e-8);
}

TEST(MapCoordinates, GiveTheTrianglesOfTheSameShapeNearTheOrigin)
{
  ASSERT_GT(here().report.new_vertices, 0U);
  EXPECT_EQ(here().triangles(), onTheMap().triangles());
}

TEST(MapCoordinates, StayBitForBit) { EXPECT_TRUE(keepsPoints(onTheMap())); }

TEST(MapCoordinates, GetNewVerticesAtTheirPlace)
{
  expectSamePlaces(here(), onTheMap(), SHIFT);
}

TEST(MapCoordinates, AreToldInTheReport)
{
  EXPECT_EQ(SHIFT, onTheMap().report.reading.global_shift);
  EXPECT_TRUE(here().report.reading.global_shift.isZero());
}

TEST(MapCoordinates, GiveBridgesInTheFrameOfTheCloud)
{
  const auto& near = here().report.bridges;
  const auto& far = onTheMap().report.bridges;
  ASSERT_FALSE(near.empty());
  ASSERT_EQ(near.size(), far.size());
  for (std::size_t i = 0; i < near.size(); ++i)
    EXPECT_LT((far[i].points[1] - near[i].points[1] - SHIFT).norm(), 1e-8);
}

TEST(MapCoordinates, ShareTheFrameWithFreePoints)
{
  const auto repairedWith = [](const Position& place) {
    ForceLineHoleRepair repair;
    repair.setInputMesh(
        pcl::make_shared<pcl::PolygonMesh>(doubleMesh(sample().damaged, place)));
    repair.setFreePoints(pcl::make_shared<pcl::PCLPointCloud2>(
        toDoubleCloud(shifted(sample().free_points, place))));
    Repaired result;
    repair.process(result.output);
    result.report = repair.getReport();
    return result;
  };
  const Repaired near = repairedWith({0, 0, 0});
  const Repaired far = repairedWith(SHIFT);
  EXPECT_EQ(near.triangles(), far.triangles());
  expectSamePlaces(near, far, SHIFT);
}

TEST(MapCoordinates, InFloatsKeepTheirBytesAndGetFloats)
{
  pcl::PolygonMesh mesh = toPolygonMesh(sample().damaged);
  mesh.cloud = toRawCloud(shifted(scaled(sample().damaged.vertices, 64.0), SHIFT));
  const Repaired result = repaired(mesh);
  EXPECT_FALSE(result.report.reading.global_shift.isZero());
  EXPECT_GT(result.report.new_triangles, 0U);
  expectNothingWorse(result, sample().wound);
}

TEST(MapCoordinates, HaveTheSameBoundaries)
{
  const auto boundariesAt = [](const Position& place) {
    BoundaryClassifier classifier;
    classifier.setInputMesh(
        pcl::make_shared<pcl::PolygonMesh>(doubleMesh(sample().damaged, place)));
    std::vector<ClassifiedBoundary> boundaries;
    EXPECT_TRUE(classifier.classify(boundaries));
    return boundaries;
  };
  const auto near = boundariesAt({0, 0, 0});
  const auto far = boundariesAt(SHIFT);
  ASSERT_FALSE(near.empty());
  ASSERT_EQ(near.size(), far.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_EQ(near[i].vertices, far[i].vertices);
    EXPECT_EQ(near[i].boundary_class, far[i].boundary_class);
    EXPECT_EQ(near[i].confidence, far[i].confidence);
  }
}

TEST(MapCoordinates, AreFilteredAsNearTheOrigin)
{
  const auto filteredAt = [](const Position& place) {
    UmbrellaFilter filter;
    Shape shape = sample().damaged;
    shape.triangles = randomlyReversed(shape.triangles, 3);
    filter.setInputMesh(pcl::make_shared<pcl::PolygonMesh>(doubleMesh(shape, place)));
    pcl::PolygonMesh filtered;
    filter.process(filtered);
    return toTriangles(filtered.polygons);
  };
  const Triangles near = filteredAt({0, 0, 0});
  EXPECT_FALSE(near.empty());
  EXPECT_EQ(near, filteredAt(SHIFT));
}

/** What told the outer side of a square that a sensor has seen, and how. */
IslandSide
sideSeenFrom(const Position& sensor)
{
  const Shape shape = grid(8, 8);
  pcl::PointCloud<pcl::PointWithViewpoint> points;
  for (const Position& vertex : shape.vertices) {
    points.push_back({});
    points.back().getVector3fMap() = vertex.cast<float>();
    points.back().vp_z = static_cast<float>(sensor.z());
  }
  pcl::PolygonMesh mesh = toPolygonMesh(shape);
  pcl::toPCLPointCloud2(points, mesh.cloud);
  GlobalShift(SHIFT).toGlobal(pcl::PCLPointCloud2(mesh.cloud), mesh.cloud);
  return repaired(mesh).report.islands.at(0).side;
}

TEST(MapCoordinates, TellTheOuterSideBySensorsThere)
{
  EXPECT_NE(sideSeenFrom({0, 0, 50}).flipped, sideSeenFrom({0, 0, -50}).flipped);
  EXPECT_EQ(SideRule::VIEWPOINT, sideSeenFrom({0, 0, 50}).rule);
}

} // namespace
} // namespace pcl::repair::test
