// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of patches that lie in the plane of their rim.

#include <pcl/surface_repair/decisions.h>

#include "support/repair_fixture.h"
#include "survey/model_survey.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace test;

/** A tower of 1 x 1 x 3 without its base at z = 0, with a flat roof. */
Shape
tower()
{
  Shape shape = cube(12);
  for (Position& p : shape.vertices)
    p.z() *= 3.0;
  return inPieces(shape, [](const Position& p) { return p.z() < 1e-9 ? -1 : 0; });
}

/** A ball without a small cap. */
Shape
openBall()
{
  return inPieces(icosphere(4), [](const Position& p) { return p.z() > 0.8 ? -1 : 0; });
}

RepairParameters
capped(Cap cap)
{
  RepairParameters parameters;
  parameters.filling.cap = cap;
  return parameters;
}

/** How far new points lie beyond heights, below the lowest or above the highest. */
double
farthestBeyond(const Repaired& result, double lowest, double highest)
{
  const ccaa::PointView points = ccaa::positionView(result.output.cloud);
  double farthest = 0.0;
  for (std::size_t i = pointsOf(result.input); i < points.size(); ++i) {
    const double height = Position(points[i]).z();
    farthest = std::max({farthest, lowest - height, height - highest});
  }
  return farthest;
}

double
lowestOf(const Shape& shape)
{
  double lowest = 1e30;
  for (const Triangle& triangle : shape.triangles)
    for (const pcl::index_t corner : triangle)
      lowest = std::min(lowest, shape.vertices[static_cast<std::size_t>(corner)].z());
  return lowest;
}

TEST(FlatCap, ClosesTheBaseOfATowerInItsPlane)
{
  const Shape shape = tower();
  const Repaired result = repaired(shape);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  ASSERT_GT(result.report.new_vertices, 20U);
  const double base = lowestOf(shape);
  EXPECT_LT(farthestBeyond(result, base, base), 1e-6);
  expectNothingWorse(result, shape.triangles);
}

TEST(FlatCap, KeepsTheEdgesAtTheRimSharp)
{
  const Repaired smooth = repaired(tower(), capped(Cap::SMOOTH));
  const double base = lowestOf(tower());
  EXPECT_GT(farthestBeyond(smooth, base, base), 0.1)
      << "this is what has to be avoided";
  const Repaired flat = repaired(tower());
  EXPECT_EQ(tower().vertices.size(), pointsOf(flat.input));
  EXPECT_LT(farthestBeyond(flat, base, base), 1e-6);
}

TEST(FlatCap, LeavesOrdinaryHolesAsRoundAsTheSurface)
{
  const Repaired as_found = repaired(openBall());
  const Repaired smooth = repaired(openBall(), capped(Cap::SMOOTH));
  EXPECT_EQ(smooth.output.cloud.data, as_found.output.cloud.data);
}

TEST(FlatCap, IsMadeAnywhereIfItIsAskedFor)
{
  const Repaired result = repaired(openBall(), capped(Cap::FLAT));
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  EXPECT_LT(farthestBeyond(result, 0.6, 0.8), 1e-6); // heights of the jagged rim
}

TEST(FlatCap, DoesNotFlattenASmallHoleInASteepWall)
{
  const Shape shape = inPieces(cube(12), [](const Position& p) {
    return p.z() > 0.99 && std::abs(p.x() - 0.5) < 0.2 && std::abs(p.y() - 0.5) < 0.2
               ? -1
               : 0;
  });
  EXPECT_EQ(repaired(shape, capped(Cap::SMOOTH)).output.cloud.data,
            repaired(shape).output.cloud.data);
}

TEST(FlatCap, GivesWayToSamplesThatAreGivenForTheMissingSurface)
{
  const Positions samples{{0.4, 0.5, -0.15}, {0.5, 0.4, -0.15}, {0.6, 0.6, -0.15}};
  const Repaired result = repaired(toPolygonMesh(tower()), samples);
  EXPECT_GT(farthestBeyond(result, lowestOf(tower()), 3.0), 0.09);
}

TEST(FlatCap, GivesWayToPointsOfTheMeshThatAreEnoughToBeItsVertices)
{
  Shape shape = tower();
  for (int i = 1; i < 20; ++i)
    for (int j = 1; j < 20; ++j)
      shape.vertices.emplace_back(0.05 * i, 0.05 * j, 0.15);
  EXPECT_GT(repaired(shape).report.new_triangles, 600U);
}

TEST(FlatCap, DoesNotFollowAFewStrayPointsOfTheMesh)
{
  Shape shape = tower();
  shape.vertices.emplace_back(0.5, 0.5, 0.7);
  shape.vertices.emplace_back(0.3, 0.6, 0.4);
  const double base = lowestOf(shape);
  EXPECT_LT(farthestBeyond(repaired(shape), base, base), 1e-6);
}

TEST(FlatCap, OfOneHoleCanBeDecidedByItself)
{
  const Shape shape = openBall();
  auto decisions = std::make_shared<Decisions>();
  decisions->mesh = fingerprintOf(toPolygonMesh(shape));
  const ModelSurvey survey = surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)), nullptr, {}, {});
  decisions->loops.resize(1);
  decisions->loops[0].key = keyOf(survey.model, survey.loops.at(0));
  decisions->loops[0].cap = Cap::FLAT;
  RepairParameters parameters;
  parameters.survey.decisions = decisions;
  EXPECT_LT(farthestBeyond(repaired(shape, parameters), 0.6, 0.8), 1e-6);
}

} // namespace
} // namespace pcl::repair
