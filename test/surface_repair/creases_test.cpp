// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of sharp edges that are carried over gaps.

#include <gtest/gtest.h>

#include "support/completion_shapes.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "survey/crease_ends.h"
#include "survey/model_survey.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;
using test::without;

constexpr double GAP = 0.3;
/** Aspect of the flat sphere, whose rim is a fold. */
constexpr double FLATNESS = 0.06;

/** A plate of 40 x 20 squares, two thick, without six columns: the creases along its
 * long sides are cut. \param[in] oblique the cut is */
Shape
halvedPlate(bool oblique = false)
{
  return without(box(40, 20, 2), [oblique](const Position& p) {
    return std::abs(p.x() - 20.0 + (oblique ? 0.7 * p.y() - 7.0 : 0.0)) < 3.0;
  });
}

Shape
halvedFlatSphere()
{
  Shape shape = icosphere(5);
  for (Position& p : shape.vertices)
    p.z() *= FLATNESS;
  return without(std::move(shape), [](const Position& p) {
    return std::abs(0.8 * p.x() + 0.6 * p.y() - 0.1) < 0.5 * GAP;
  });
}

std::vector<Bridge>
creasesOf(const Shape& shape)
{
  std::vector<Bridge> creases;
  const ModelSurvey survey = surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)), nullptr, {}, {});
  for (const Bridge& bridge : survey.joined.bridges)
    if (bridge.is_crease)
      creases.push_back(bridge);
  return creases;
}

TEST(Creases, EndAtALoopWhereSharpEdgesAreCut)
{
  const IncompleteModel model = modelOf(halvedPlate());
  for (const BoundaryLoop& loop : extractBoundaries(model)) {
    const std::vector<CreaseEnd> ends = creaseEnds(model, loop);
    ASSERT_EQ(4U, ends.size());
    for (const CreaseEnd& end : ends) {
      const double away = loop.curve.points[end.vertex].x() < 20.0 ? 1.0 : -1.0;
      EXPECT_NEAR(away, end.along.x(), 1e-9);
      EXPECT_NEAR(std::sqrt(0.5), std::abs(end.normal.y()), 1e-9);
      EXPECT_NEAR(std::sqrt(0.5), std::abs(end.normal.z()), 1e-9);
      EXPECT_TRUE(end.is_convex);
    }
  }
}

TEST(Creases, OfAHollowAreNotConvex)
{
  Shape plate = halvedPlate();
  plate.triangles = reversed(std::move(plate.triangles));
  const IncompleteModel model = modelOf(plate);
  const std::vector<CreaseEnd> ends = creaseEnds(model, extractBoundaries(model)[0]);
  ASSERT_EQ(4U, ends.size());
  EXPECT_TRUE(std::none_of(
      ends.begin(), ends.end(), [](const CreaseEnd& end) { return end.is_convex; }));
}

TEST(Creases, GoOnAlongEdgesOfTheBoundaryThatHaveOneOfTheirSides)
{
  const IncompleteModel model = modelOf(halvedPlate(true));
  for (const BoundaryLoop& loop : extractBoundaries(model))
    for (const CreaseEnd& end : creaseEnds(model, loop)) {
      const std::size_t count = loop.curve.size();
      for (const std::size_t step : {std::size_t{1}, count - 1}) {
        const Eigen::Vector3d next = loop.curve.points[(end.vertex + step) % count] -
                                     loop.curve.points[end.vertex];
        EXPECT_LT(next.normalized().dot(end.along), 0.95);
      }
    }
}

TEST(Creases, AreNoneOfASphereWithAHole)
{
  const IncompleteModel model =
      modelOf(without(icosphere(4), [](const Position& p) { return p.z() > 0.8; }));
  SurfaceEnds surface_ends(model);
  const BoundaryLoop loop = extractBoundaries(model)[0];
  EXPECT_TRUE(creaseEnds(model, loop).empty());
  EXPECT_TRUE(foldEnds(surface_ends, loop, 0.1 * loop.length, {}).empty());
}

TEST(Creases, FoldsAreInTheMiddleOfTheTurn)
{
  const IncompleteModel model = modelOf(halvedFlatSphere());
  SurfaceEnds surface_ends(model);
  for (const BoundaryLoop& loop : extractBoundaries(model)) {
    const std::vector<CreaseEnd> ends = foldEnds(surface_ends, loop, GAP, {});
    ASSERT_EQ(2U, ends.size());
    for (const CreaseEnd& end : ends) {
      EXPECT_LT(std::abs(loop.curve.points[end.vertex].z()), 0.1 * FLATNESS);
      EXPECT_GT(end.normal.dot(loop.curve.points[end.vertex].normalized()), 0.95);
      EXPECT_TRUE(end.is_convex);
    }
  }
}

TEST(Creases, NoFoldIsNearAKnownEnd)
{
  const IncompleteModel model = modelOf(halvedPlate());
  SurfaceEnds surface_ends(model);
  const BoundaryLoop loop = extractBoundaries(model)[0];
  EXPECT_TRUE(foldEnds(surface_ends, loop, 5.0, creaseEnds(model, loop)).empty());
  EXPECT_EQ(2U, foldEnds(surface_ends, loop, 5.0, {}).size());
}

TEST(Creases, AreCarriedStraightOverTheGapOfAPlate)
{
  for (const bool oblique : {false, true}) {
    const std::vector<Bridge> creases = creasesOf(halvedPlate(oblique));
    ASSERT_EQ(4U, creases.size());
    for (const Bridge& crease : creases)
      for (const Position& point : crease.points) {
        EXPECT_NEAR(crease.points[0].y(), point.y(), 1e-6);
        EXPECT_NEAR(crease.points[0].z(), point.z(), 1e-6);
      }
  }
}

TEST(Creases, AreCarriedLikeAnArcAroundARim)
{
  const std::vector<Bridge> creases = creasesOf(halvedFlatSphere());
  ASSERT_EQ(2U, creases.size());
  for (const Bridge& crease : creases)
    for (const Position& point : crease.points)
      EXPECT_NEAR(1.0, std::hypot(point.x(), point.y()), 0.005);
}

TEST(Creases, ArePassedByContoursAndCostNoHandle)
{
  const ModelSurvey survey =
      surveyModel(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(halvedPlate())),
                  nullptr,
                  {},
                  {});
  std::size_t passed = 0;
  for (const HoleContour& contour : survey.joined.holes.contours)
    for (const ContourStep& step : contour.steps)
      passed += step.bridge != NONE && survey.joined.bridges[step.bridge].is_crease;
  EXPECT_EQ(8U, passed) << "each on both of its sides";
}

} // namespace
} // namespace pcl::repair
