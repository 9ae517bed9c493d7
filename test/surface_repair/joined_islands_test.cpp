// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what bridges between islands make of a model.

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "survey/model_survey.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::without;

ModelSurvey
survey(const Shape& shape)
{
  return surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)), nullptr, {}, {});
}

/** The shape without slabs of a thickness across x, y and z. */
Shape
inPieces(Shape shape, double thickness)
{
  return without(std::move(shape), [thickness](const Position& p) {
    return p.cwiseAbs().minCoeff() < 0.5 * thickness;
  });
}

/** A torus without three slices across its ring. */
Shape
inThreeTubes(int around)
{
  return without(torus(around, 40), [](const Position& p) {
    const double angle = std::atan2(p.y(), p.x());
    return std::abs(std::remainder(angle, 2.0943951023931953)) < 0.12;
  });
}

/** Euler characteristic of the model once every contour is closed by a disc: islands
 * and discs are joined along bridges, which are edges without a vertex of their own. */
long
closedCharacteristic(const ModelSurvey& found)
{
  const auto vertices = static_cast<long>(found.model.positions.size());
  const auto triangles = static_cast<long>(found.model.triangles.size());
  long border = 0;
  for (const BoundaryLoop& loop : found.loops)
    border += static_cast<long>(loop.vertices.size());
  const long edges = (3 * triangles + border) / 2;
  const auto bridges = static_cast<long>(found.joined.bridges.size() -
                                         found.joined.holes.removed_bridges.size());
  const auto other_loops =
      static_cast<long>(found.loops.size() - found.joined.loops.size());
  return vertices - edges + triangles - bridges +
         static_cast<long>(found.joined.holes.contours.size()) + other_loops;
}

struct JoinedCase {
  const char* name;
  Shape shape;
  std::size_t islands;
  long characteristic;
};

std::ostream&
operator<<(std::ostream& out, const JoinedCase& joined)
{
  return out << joined.name;
}

std::vector<JoinedCase>
joinedCases()
{
  return {
      {"SphereInEightPieces", inPieces(icosphere(4), 0.15), 8, 2},
      {"SphereInEightPiecesFarApart", inPieces(icosphere(4), 0.35), 8, 2},
      {"CapInAPolarHole",
       without(icosphere(4),
               [](const Position& p) { return p.z() > 0.6 && p.z() < 0.85; }),
       2,
       2},
      {"CubeInEightPieces",
       inPieces(translated(cube(24, 2.0), Position(-1, -1, -1)), 0.2),
       8,
       2},
      {"TorusInEightPieces", inPieces(torus(96, 40), 0.12), 8, 0},
      {"TorusInThreeTubes", inThreeTubes(96), 3, 0},
      {"NestedSpheresInPieces", inPieces(nestedSpheres(4), 0.12), 16, 4},
  };
}

class JoinedIslands : public ::testing::TestWithParam<JoinedCase> {};

TEST_P(JoinedIslands, HaveTheTopologyOfTheWholeObject)
{
  const ModelSurvey found = survey(GetParam().shape);
  ASSERT_EQ(GetParam().islands, found.counts.islands);
  EXPECT_EQ(GetParam().characteristic, closedCharacteristic(found));
}

TEST_P(JoinedIslands, AreAllReached)
{
  const ModelSurvey found = survey(GetParam().shape);
  for (const HoleContour& contour : found.joined.holes.contours)
    EXPECT_NE(NONE, contour.steps.front().bridge);
}

std::string
nameOf(const ::testing::TestParamInfo<JoinedCase>& tested)
{
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         JoinedIslands,
                         ::testing::ValuesIn(joinedCases()),
                         nameOf);

TEST(JoinedIslands, OuterBorderOfATerrainGetsNoBridge)
{
  const ModelSurvey found = survey(without(terrain(50, 50, 1.0), [](const Position& p) {
    const double radius = std::hypot(p.x() - 25.0, p.y() - 25.0);
    return radius > 6.0 && radius < 9.0;
  }));
  for (std::size_t k = 0; k < found.joined.loops.size(); ++k) {
    if (found.classes[found.joined.loops[k]].boundary_class !=
        BoundaryClass::OUTER_BORDER)
      continue;
    for (const Bridge& bridge : found.joined.bridges)
      EXPECT_TRUE(bridge.begin.curve != k && bridge.end.curve != k);
  }
  EXPECT_GT(found.joined.bridges.size(), 4U);
}

/** Two caps with a wide gap, of which a rim has the length of five. */
ModelSurvey
capsWithLinesApart(double line_spacing)
{
  SurveyParameters parameters;
  parameters.trace_in_holes = false;
  parameters.line_spacing = line_spacing;
  const Shape caps =
      without(icosphere(4), [](const Position& p) { return std::abs(p.z()) < 0.5; });
  return surveyModel(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(caps)), nullptr, parameters, {});
}

/** There is room for one line at each rim, and one bridge alone is deleted. */
TEST(LostBridges, LinesAreTracedAnewBetweenTheirIslands)
{
  const ModelSurvey found = capsWithLinesApart(4.0);
  EXPECT_GT(found.between_islands.lines.size(), 2U);
  EXPECT_GT(found.joined.bridges.size() - found.joined.holes.removed_bridges.size(),
            1U);
}

TEST(LostBridges, NoLineIsTracedTwice)
{
  const ModelSurvey found = capsWithLinesApart(4.0);
  const std::vector<ForceLine>& lines = found.between_islands.lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(lines[k].points.front(), lines[i].points.front());
}

TEST(LostBridges, WhereNoneIsLostNothingIsTracedAnew)
{
  const ModelSurvey found = capsWithLinesApart(1.0);
  std::vector<std::size_t> of_rim(2, 0);
  for (const ForceLine& line : found.between_islands.lines)
    ++of_rim[line.origin.curve];
  EXPECT_LE(of_rim[0], 6U);
  EXPECT_LE(of_rim[1], 6U);
}

} // namespace
} // namespace pcl::repair
