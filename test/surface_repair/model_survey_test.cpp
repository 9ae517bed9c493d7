// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the survey of an incomplete model.

#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/shared_data.h"
#include "surface_repair/boundary/boundary_models.h"
#include "survey/model_survey.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::without;

pcl::PolygonMesh::Ptr
meshOf(const Shape& shape)
{
  return pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape));
}

ModelSurvey
survey(const pcl::PolygonMesh::ConstPtr& mesh,
       const SurveyParameters& parameters = {},
       int threads = 1)
{
  ccaa::LoopContext context;
  context.threads = threads;
  return surveyModel(mesh, nullptr, parameters, context);
}

/** A sphere without the belt |z| <= 0.2. */
Shape
twoCaps()
{
  return without(icosphere(4), [](const Position& p) { return std::abs(p.z()) < 0.2; });
}

/** A sphere with a round hole of 40 degrees around z. */
Shape
sphereWithHole()
{
  return without(icosphere(4), [](const Position& p) { return p.z() > 0.75; });
}

std::size_t
bridgesOf(const SurveyedField& field)
{
  return static_cast<std::size_t>(
      std::count_if(field.lines.begin(), field.lines.end(), [](const ForceLine& line) {
        return line.end == LineEnd::BRIDGE;
      }));
}

TEST(ModelSurvey, TwoCapsAreOfClassThree)
{
  const ModelSurvey found = survey(meshOf(twoCaps()));
  EXPECT_EQ(IcmClass::ICM3, found.icm_class);
  EXPECT_EQ(2U, found.counts.islands);
}

TEST(ModelSurvey, LineFromEveryChosenOriginReachesTheOtherCap)
{
  const ModelSurvey found = survey(meshOf(twoCaps()));
  EXPECT_GT(found.between_islands.lines.size(), 20U);
  EXPECT_EQ(found.between_islands.lines.size(), bridgesOf(found.between_islands));
}

TEST(ModelSurvey, FlippedCapIsTurnedAndJoinedAllTheSame)
{
  Shape shape = twoCaps();
  for (Triangle& triangle : shape.triangles)
    if (shape.vertices[static_cast<std::size_t>(triangle[0])].z() < 0.0)
      std::swap(triangle[1], triangle[2]);
  const ModelSurvey found = survey(meshOf(shape));
  EXPECT_NE(found.sides[0].flipped, found.sides[1].flipped);
  EXPECT_EQ(found.between_islands.lines.size(), bridgesOf(found.between_islands));
}

TEST(ModelSurvey, LargeHoleIsComplexAndGetsLinesAcross)
{
  const ModelSurvey found = survey(meshOf(sphereWithHole()));
  EXPECT_EQ(IcmClass::ICM2, found.icm_class);
  ASSERT_EQ(1U, found.in_holes.size());
  EXPECT_GT(bridgesOf(found.in_holes[0]), 0U);
}

TEST(ModelSurvey, LineInAHoleOfASphereBulgesOutOfItsChordsPlane)
{
  const ModelSurvey found = survey(meshOf(sphereWithHole()));
  double highest = 0.0;
  double rim = 0.0;
  for (const Position& point : found.loops[0].curve.points)
    rim = std::max(rim, point.z());
  for (const ForceLine& line : found.in_holes[0].lines)
    for (const Position& point : line.points)
      highest = std::max(highest, point.z());
  EXPECT_GT(highest, rim);
}

TEST(ModelSurvey, MoreSimpleEdgesMakeTheHoleSimple)
{
  SurveyParameters parameters;
  parameters.simple_edges = 1000;
  const ModelSurvey found = survey(meshOf(sphereWithHole()), parameters);
  EXPECT_EQ(IcmClass::ICM1, found.icm_class);
  EXPECT_TRUE(found.in_holes.empty());
}

TEST(ModelSurvey, ClosedMeshHasNothingToTrace)
{
  const ModelSurvey found = survey(meshOf(icosphere(3)));
  EXPECT_TRUE(found.loops.empty());
  EXPECT_TRUE(found.between_islands.lines.empty());
  EXPECT_EQ(IcmClass::ICM1, found.icm_class);
}

TEST(ModelSurvey, MeshWithoutTrianglesIsAProblem)
{
  Shape shape = icosphere(1);
  shape.triangles.clear();
  EXPECT_NE("", survey(meshOf(shape)).reading.problem);
}

TEST(ModelSurvey, FullModeJoinsTheCapsToo)
{
  SurveyParameters full;
  full.field.mode = FieldMode::FULL;
  const ModelSurvey found = survey(meshOf(twoCaps()), full);
  EXPECT_GT(found.between_islands.lines.size(), 20U);
  EXPECT_EQ(found.between_islands.lines.size(), bridgesOf(found.between_islands));
}

TEST(ModelSurvey, FreePointsOnTheSphereLiftTheLines)
{
  Shape shape = sphereWithHole();
  for (const Position& point : icosphere(3).vertices)
    if (point.z() > 0.8)
      shape.vertices.push_back(point); // unused: free points
  const auto top = [](const ModelSurvey& found) {
    double highest = 0.0;
    for (const ForceLine& line : found.in_holes.at(0).lines)
      for (const Position& point : line.points)
        highest = std::max(highest, point.z());
    return highest;
  };
  SurveyParameters without_trust;
  without_trust.field.trust = 0.0;
  EXPECT_GT(top(survey(meshOf(shape))), top(survey(meshOf(shape), without_trust)));
}

TEST(ModelSurvey, MoreTrustInFreePointsLiftsTheLinesMore)
{
  Shape shape = sphereWithHole();
  for (const Position& point : icosphere(3).vertices)
    if (point.z() > 0.8)
      shape.vertices.push_back(1.05 * point); // above the sphere
  const auto lift = [&shape](double trust) {
    SurveyParameters parameters;
    parameters.field.trust = trust;
    const ModelSurvey found = survey(meshOf(shape), parameters);
    double sum = 0.0;
    for (const ForceLine& line : found.in_holes.at(0).lines)
      for (const Position& point : line.points)
        sum += point.z();
    return sum;
  };
  EXPECT_GT(lift(0.9), lift(0.3));
}

TEST(ModelSurvey, ResultIsTheSameForAnyNumberOfThreads)
{
  const auto mesh = meshOf(twoCaps());
  const ModelSurvey one = survey(mesh);
  const ModelSurvey seven = survey(mesh, {}, 7);
  ASSERT_EQ(one.between_islands.lines.size(), seven.between_islands.lines.size());
  for (std::size_t i = 0; i < one.between_islands.lines.size(); ++i)
    EXPECT_EQ(one.between_islands.lines[i].points,
              seven.between_islands.lines[i].points);
}

TEST(ModelSurvey, CancelledRunSaysSo)
{
  ccaa::RunControl control([](const std::string&, double) { return false; });
  ccaa::LoopContext context;
  context.control = &control;
  const ModelSurvey found = surveyModel(meshOf(twoCaps()), nullptr, {}, context);
  EXPECT_TRUE(found.cancelled || !found.reading.problem.empty());
}

TEST(ModelSurvey, EachHoleOfTheBunnyGetsABridge)
{
  const std::string path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  ASSERT_GE(pcl::io::loadPLYFile(path, *mesh), 0);
  const ModelSurvey found = survey(mesh);
  EXPECT_EQ(5U, found.in_holes.size());
  for (const SurveyedField& hole : found.in_holes)
    EXPECT_GT(bridgesOf(hole), 0U);
}

TEST(FieldSlice, TensionIsGreatestBetweenTheCapsAndNoneFarInside)
{
  const ModelSurvey found = survey(meshOf(twoCaps()));
  const FieldSlice slice = sliceField(found, {}, 41, ccaa::LoopContext());
  ASSERT_EQ(slice.columns * slice.rows, slice.tension.size());
  const double greatest = *std::max_element(slice.tension.begin(), slice.tension.end());
  const double centre =
      slice.tension[slice.rows / 2 * slice.columns + slice.columns / 2];
  EXPECT_GT(greatest, 0.0);
  EXPECT_LT(centre, 0.5 * greatest);
}

TEST(FieldSlice, OneIslandAloneMakesASliceWithoutAProblem)
{
  const ModelSurvey found = survey(meshOf(sphereWithHole()));
  const FieldSlice slice = sliceField(found, {}, 21, ccaa::LoopContext());
  EXPECT_EQ(slice.columns * slice.rows, slice.tension.size());
}

} // namespace
} // namespace pcl::repair
