// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of mesh/orientation.h.
#include <gtest/gtest.h>

#include "mesh/orientation.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <limits>

namespace pcl::ccaa::test {
namespace {

OrientationReport
orient(Shape& shape, const OrientationHints& hints = {})
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  RunControl control;
  return orientTriangles(shape.triangles, adjacency, shape.vertices, hints, control);
}

/** \brief Turns triangles at random, orients, and expects the windings of before. */
OrientationReport
expectRestored(const Shape& shape, const OrientationHints& hints = {})
{
  Shape raw = shape;
  raw.triangles = randomlyReversed(shape.triangles, 11);
  const OrientationReport report = orient(raw, hints);
  EXPECT_TRUE(sameTriangles(shape.triangles, raw.triangles));
  return report;
}

std::size_t
decidedBy(const OrientationReport& report, OutwardRule rule)
{
  return report.decided[static_cast<std::size_t>(rule)];
}

TEST(Orientation, WindsClosedShapesOutwardByTheirVolume)
{
  for (const Shape& shape :
       {tetrahedron(), icosphere(3), torus(24, 12), cube(4), icosphere(2, 1e-4)}) {
    const OrientationReport report = expectRestored(shape);
    EXPECT_EQ(decidedBy(report, OutwardRule::VOLUME), 1u);
  }
}

TEST(Orientation, CountsTheTrianglesItHasReversed)
{
  Shape shape = icosphere(2);
  std::swap(shape.triangles[0][1], shape.triangles[0][2]);
  std::swap(shape.triangles[7][1], shape.triangles[7][2]);
  EXPECT_EQ(orient(shape).reversed, 2u);
}

TEST(Orientation, LeavesACorrectMeshUntouched)
{
  Shape shape = torus(20, 10);
  const Triangles before = shape.triangles;
  EXPECT_EQ(orient(shape).reversed, 0u);
  EXPECT_EQ(shape.triangles, before);
}

TEST(Orientation, IsTheSameFarFromTheOrigin)
{
  expectRestored(translated(icosphere(3), {1e5, -2e5, 3e5}));
}

TEST(Orientation, WindsEachNestedShellByItsOwnVolume)
{
  const OrientationReport report = expectRestored(nestedSpheres(2));
  EXPECT_EQ(report.components.size(), 2u);
  EXPECT_EQ(decidedBy(report, OutwardRule::VOLUME), 2u);
}

TEST(Orientation, DecidesOpenShapesByFreeSight)
{
  Shape open_sphere = icosphere(3);
  open_sphere.triangles.resize(open_sphere.triangles.size() - 30);
  for (const Shape& shape : {open_sphere, cylinder(24, 10)}) {
    const OrientationReport report = expectRestored(shape);
    EXPECT_EQ(decidedBy(report, OutwardRule::ENCLOSING_SPHERE), 1u);
  }
}

TEST(Orientation, SeesTwoSheetsFromBothSides)
{
  const OrientationReport report = expectRestored(thinPlate(12, 12, 1.0));
  EXPECT_EQ(decidedBy(report, OutwardRule::ENCLOSING_SPHERE), 2u);
}

TEST(Orientation, ASheetHiddenByAnotherIsDecidedByItsBulge)
{
  // The smaller half shell lies entirely in the shadow of the closed one around it.
  Shape inner = icosphere(3, 0.3);
  inner.triangles.resize(inner.triangles.size() / 2);
  const OrientationReport report = expectRestored(joined(icosphere(3), inner));
  EXPECT_EQ(decidedBy(report, OutwardRule::BULGE), 1u);
}

TEST(Orientation, AFlatSheetIsUndecidedAndKeepsMostOfItsWindings)
{
  Shape sheet = grid(9, 9);
  sheet.triangles[3] = {
      sheet.triangles[3][0], sheet.triangles[3][2], sheet.triangles[3][1]};
  const OrientationReport report = orient(sheet);
  EXPECT_EQ(decidedBy(report, OutwardRule::UNDECIDED), 1u);
  EXPECT_EQ(report.reversed, 1u);
  EXPECT_TRUE(sameTriangles(grid(9, 9).triangles, sheet.triangles));
}

TEST(Orientation, NormalsDecideBeforeVolume)
{
  Shape cavity = icosphere(2);
  Positions normals = cavity.vertices;
  for (Position& normal : normals)
    normal *= -3.0;
  cavity.triangles = reversed(cavity.triangles);
  OrientationHints hints;
  hints.normals = normals;
  EXPECT_EQ(decidedBy(expectRestored(cavity, hints), OutwardRule::NORMALS), 1u);
}

TEST(Orientation, IgnoresNormalsThatAreZeroOrNotFinite)
{
  const Shape sheet = grid(6, 6);
  Positions normals(sheet.vertices.size(), Position::Zero());
  normals[3].setConstant(std::numeric_limits<double>::quiet_NaN());
  normals[8] = {0.0, 0.0, 0.01};
  OrientationHints hints;
  hints.normals = normals;
  EXPECT_EQ(decidedBy(expectRestored(sheet, hints), OutwardRule::NORMALS), 1u);
}

TEST(Orientation, ContradictingNormalsDecideNothing)
{
  const Shape sphere = icosphere(3);
  Positions normals = sphere.vertices;
  for (std::size_t i = 0; i < normals.size(); i += 2)
    normals[i] = -normals[i];
  OrientationHints hints;
  hints.normals = normals;
  EXPECT_EQ(decidedBy(expectRestored(sphere, hints), OutwardRule::VOLUME), 1u);
}

TEST(Orientation, ASheetFacesTheSensor)
{
  OrientationHints hints;
  hints.viewpoint = Position(5.0, 5.0, 30.0);
  const Shape sheet = terrain(20, 20);
  EXPECT_EQ(decidedBy(expectRestored(sheet, hints), OutwardRule::VIEWPOINT), 1u);
}

TEST(Orientation, ASensorInsideARoomSeesItsWallsFromInside)
{
  Shape room = cube(6, 4.0);
  room.triangles = reversed(room.triangles);
  OrientationHints hints;
  hints.viewpoint = Position(1.0, 2.5, 1.5);
  EXPECT_EQ(decidedBy(expectRestored(room, hints), OutwardRule::VIEWPOINT), 1u);
}

TEST(Orientation, ASensorOutsideAClosedShapeLeavesItToTheVolume)
{
  OrientationHints hints;
  hints.viewpoint = Position(0.0, 0.0, 1.5);
  EXPECT_EQ(decidedBy(expectRestored(icosphere(4), hints), OutwardRule::VOLUME), 1u);
}

TEST(Orientation, ViewpointsOfEachVertexServeAClosedShape)
{
  const Shape sphere = icosphere(3);
  Positions viewpoints = sphere.vertices;
  for (Position& viewpoint : viewpoints)
    viewpoint *= 4.0;
  OrientationHints hints;
  hints.viewpoints = viewpoints;
  EXPECT_EQ(decidedBy(expectRestored(sphere, hints), OutwardRule::VIEWPOINT), 1u);
}

TEST(Orientation, LeavesOneSidedComponentsAlone)
{
  Shape shape = joined(moebiusBand(12), translated(icosphere(1), {5.0, 0.0, 0.0}));
  shape.triangles = randomlyReversed(shape.triangles, 4);
  const Triangles before = shape.triangles;
  const OrientationReport report = orient(shape);
  EXPECT_EQ(report.oneSided(), 1u);
  EXPECT_EQ(report.components[0].rule, OutwardRule::ONE_SIDED);
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + 24, shape.triangles.begin()));
}

TEST(Orientation, TurnsNothingWhenItIsToStopAtAOneSidedComponent)
{
  Shape shape = joined(moebiusBand(12), translated(icosphere(1), {5.0, 0.0, 0.0}));
  shape.triangles = randomlyReversed(shape.triangles, 4);
  const Triangles before = shape.triangles;
  OrientationHints hints;
  hints.stop_if_one_sided = true;
  const OrientationReport report = orient(shape, hints);
  EXPECT_EQ(report.oneSided(), 1u);
  EXPECT_EQ(report.reversed, 0u);
  EXPECT_EQ(shape.triangles, before);
}

TEST(Orientation, DoesNotCrossAnEdgeOfThreeTriangles)
{
  Shape shape = threeOnEdge();
  EXPECT_EQ(orient(shape).components.size(), 3u);
}

TEST(Orientation, DoesNotCrossABowTie)
{
  Shape shape = bowTie();
  EXPECT_EQ(orient(shape).components.size(), 2u);
}

TEST(Orientation, ListsComponentsByTheirLowestTriangle)
{
  Shape shape =
      shuffled(joined(icosphere(2), translated(torus(9, 6), {4.0, 0.0, 0.0})), 5);
  const OrientationReport report = orient(shape);
  ASSERT_EQ(report.components.size(), 2u);
  EXPECT_EQ(report.components[0].first_triangle, 0);
  EXPECT_LT(report.components[0].first_triangle, report.components[1].first_triangle);
  EXPECT_EQ(report.components[0].triangles + report.components[1].triangles,
            shape.triangles.size());
}

TEST(Orientation, EmptyMeshHasNoComponents)
{
  Shape shape;
  EXPECT_TRUE(orient(shape).components.empty());
}

TEST(Orientation, TrianglesThatAreNotFiniteDoNotVote)
{
  Shape shape = icosphere(3);
  shape.vertices[5].setConstant(std::numeric_limits<double>::quiet_NaN());
  expectRestored(shape);
}

TEST(Orientation, ADoubledTriangleIsClosedWithoutAVolume)
{
  Shape shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
  const OrientationReport report = orient(shape);
  EXPECT_EQ(decidedBy(report, OutwardRule::VOLUME), 0u);
  EXPECT_TRUE(isConsistentlyWound(shape.triangles));
}

/** \brief Large enough for several parts, with components across their borders. */
Shape
largeRawShape(bool in_random_order)
{
  Shape shape =
      joined(torus(250, 200), translated(cylinder(250, 199), {3.0, 0.0, 0.0}));
  shape = joined(shape, translated(terrain(250, 200), {0.0, 0.0, -9.0}));
  if (in_random_order)
    shape = shuffled(shape, 8);
  shape.triangles = randomlyReversed(shape.triangles, 9);
  return shape;
}

TEST(Orientation, IsBitIdenticalForAnyNumberOfThreads)
{
  for (const bool in_random_order : {false, true}) {
    Shape reference = largeRawShape(in_random_order);
    const OrientationReport expected = orient(reference);
    for (const int threads : {2, 3, 5}) {
      Shape shape = largeRawShape(in_random_order);
      OrientationHints hints;
      hints.threads = threads;
      const OrientationReport report = orient(shape, hints);
      EXPECT_EQ(shape.triangles, reference.triangles);
      EXPECT_EQ(report.reversed, expected.reversed);
      ASSERT_EQ(report.components.size(), expected.components.size());
      for (std::size_t i = 0; i < report.components.size(); ++i)
        EXPECT_EQ(report.components[i].margin, expected.components[i].margin);
    }
  }
}

TEST(Orientation, FindsAOneSidedComponentThatSeveralThreadsShare)
{
  Shape band = moebiusBand(60000);
  OrientationHints hints;
  hints.threads = 2;
  EXPECT_EQ(orient(band, hints).oneSided(), 1u);
}

TEST(Orientation, CountsTheWindingsOfAllThreads)
{
  Shape sheet = grid(300, 300);
  const Triangles expected = sheet.triangles;
  for (std::size_t i = 0; i < 4 * expected.size() / 10; ++i)
    std::swap(sheet.triangles[i][1], sheet.triangles[i][2]);
  OrientationHints hints;
  hints.threads = 2;
  EXPECT_EQ(orient(sheet, hints).reversed, 4 * expected.size() / 10);
  EXPECT_EQ(sheet.triangles, expected);
}

TEST(Orientation, CancellingLeavesTheTrianglesAsTheyWere)
{
  Shape shape = largeRawShape(false);
  const Triangles before = shape.triangles;
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  int calls = 0;
  RunControl control([&](const std::string&, double) { return ++calls < 3; });
  EXPECT_TRUE(orientTriangles(shape.triangles, adjacency, shape.vertices, {}, control)
                  .cancelled);
  EXPECT_EQ(shape.triangles, before);
}

} // namespace
} // namespace pcl::ccaa::test
