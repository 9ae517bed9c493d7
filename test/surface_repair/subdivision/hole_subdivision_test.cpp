// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of dividing complex holes.

#include <gtest/gtest.h>

#include "field/shielding.h"
#include "subdivision/hole_subdivision.h"
#include "subdivision_samples.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace pcl::repair {
namespace {

using test::capHole;
using test::combHole;
using test::divided;
using test::passagesOf;
using test::saddleHole;
using test::spiralHole;

/** Contours of different kinds, all of more than 60 edges. */
std::vector<HolePolygon>
contours()
{
  HolePolygon spike = capHole(80, 0.5);
  spike.curve.points[20] *= 5.0;
  return {capHole(100, 0.6),
          capHole(300, 1.4),
          saddleHole(120),
          combHole(4),
          spiralHole(),
          spike,
          test::flatHole({{0, 0, 0}, {0, 0.5, 0}, {20, 0.5, 0}, {20, 0, 0}}, 0.25)};
}

bool
isNewVertex(const HolePolygon& hole, pcl::index_t vertex)
{
  return static_cast<std::size_t>(vertex) >= hole.size();
}

TEST(HoleSubdivision, SimpleHoleStaysWhole)
{
  const HolePolygon hole = capHole(30, 0.5);
  const DividedHole whole = divided(hole, 30);
  ASSERT_EQ(1U, whole.holes.size());
  EXPECT_EQ(hole.vertices, whole.holes.front().vertices);
  EXPECT_TRUE(whole.bridges.empty());
  EXPECT_TRUE(whole.new_vertices.empty());
}

TEST(HoleSubdivision, PartsAreSimple)
{
  for (const HolePolygon& hole : {capHole(100, 0.6), capHole(300, 1.4), combHole(4)})
    for (const std::size_t simple_edges : {12, 40})
      for (const HolePolygon& part : divided(hole, simple_edges).holes)
        EXPECT_LE(part.size(), simple_edges);
}

TEST(HoleSubdivision, EveryEdgeOfTheContourBelongsToOnePart)
{
  for (const HolePolygon& hole : contours()) {
    const auto passages = passagesOf(divided(hole, 20).holes);
    for (std::size_t k = 0; k < hole.size(); ++k) {
      const pcl::index_t a = hole.vertices[k], b = hole.vertices[hole.curve.next(k)];
      EXPECT_EQ(1, passages.at({a, b}));
      EXPECT_EQ(0U, passages.count({b, a}));
    }
  }
}

TEST(HoleSubdivision, EveryOtherEdgeBelongsToTwoPartsInOppositeDirections)
{
  for (const HolePolygon& hole : contours()) {
    const auto passages = passagesOf(divided(hole, 20).holes);
    std::size_t open = 0;
    for (const auto& [edge, times] : passages) {
      EXPECT_EQ(1, times);
      open += passages.count({edge.second, edge.first}) == 0 ? 1 : 0;
    }
    EXPECT_EQ(hole.size(), open);
  }
}

TEST(HoleSubdivision, PartsTogetherAreADisc)
{
  for (const HolePolygon& hole : contours()) {
    const DividedHole parts = divided(hole, 20);
    std::set<pcl::index_t> vertices;
    for (const HolePolygon& part : parts.holes)
      vertices.insert(part.vertices.begin(), part.vertices.end());
    const std::size_t edges = (passagesOf(parts.holes).size() + hole.size()) / 2;
    EXPECT_EQ(hole.size() + parts.new_vertices.size(), vertices.size());
    EXPECT_EQ(edges + 1, vertices.size() + parts.holes.size());
    EXPECT_EQ(parts.bridges.size() + 1, parts.holes.size());
  }
}

TEST(HoleSubdivision, PartsAreSmallerThanWhatWasDivided)
{
  for (const HolePolygon& hole : contours())
    for (const HolePolygon& part : divided(hole, hole.size() - 1).holes) {
      EXPECT_LT(part.size(), hole.size());
      EXPECT_GE(part.size(), 3U);
    }
}

TEST(HoleSubdivision, PartsHaveAPointANormalAndAVertexForEachEdge)
{
  const HolePolygon hole = capHole(120, 0.8);
  const DividedHole parts = divided(hole, 20);
  for (const HolePolygon& part : parts.holes) {
    ASSERT_EQ(part.size(), part.curve.points.size());
    ASSERT_EQ(part.size(), part.curve.normals.size());
    for (std::size_t k = 0; k < part.size(); ++k) {
      const auto vertex = static_cast<std::size_t>(part.vertices[k]);
      const Position& place = isNewVertex(hole, part.vertices[k])
                                  ? parts.new_vertices[vertex - hole.size()]
                                  : hole.curve.points[vertex];
      EXPECT_EQ(place, part.curve.points[k]);
      EXPECT_NEAR(1.0, part.curve.normals[k].norm(), 1e-9);
    }
  }
}

TEST(HoleSubdivision, NormalsOfBridgesAreThoseOfTheSurface)
{
  for (const HolePolygon& part : divided(capHole(120, 0.7), 20).holes)
    for (std::size_t k = 0; k < part.size(); ++k)
      EXPECT_GT(part.curve.normals[k].dot(part.curve.points[k].normalized()), 0.7);
}

TEST(HoleSubdivision, BridgesOverACapLieNearTheSphere)
{
  for (const Position& point : divided(capHole(100, 0.5), 20).new_vertices)
    EXPECT_NEAR(1.0, point.norm(), 0.13); // the plane of the rim: 0.12
}

TEST(HoleSubdivision, BridgesHaveTheSpacingOfTheContour)
{
  const double spacing = 2.0 * std::sin(0.6) * std::sin(M_PI / 100.0);
  double sum = 0.0;
  std::size_t count = 0;
  for (const DividingBridge& bridge : divided(capHole(100, 0.6), 30).bridges)
    for (std::size_t k = 0; k + 1 < bridge.points.size(); ++k, ++count) {
      const double length = (bridge.points[k + 1] - bridge.points[k]).norm();
      EXPECT_GT(length, 0.4 * spacing);
      EXPECT_LT(length, 3.0 * spacing);
      sum += length;
    }
  EXPECT_NEAR(spacing, sum / static_cast<double>(count), 0.3 * spacing);
}

TEST(HoleSubdivision, BridgesHaveDifferentEndsAndKeepQuality)
{
  for (const DividingBridge& bridge : divided(saddleHole(120), 12).bridges) {
    ASSERT_GE(bridge.vertices.size(), 2U);
    EXPECT_EQ(bridge.vertices.size(), bridge.points.size());
    EXPECT_EQ(bridge.vertices.size(), bridge.normals.size());
    EXPECT_NE(bridge.vertices.front(), bridge.vertices.back());
    EXPECT_GT(bridge.quality, 0.0);
  }
}

TEST(HoleSubdivision, StripIsCutAcross)
{
  const HolePolygon strip =
      test::flatHole({{0, 0, 0}, {0, 1, 0}, {20, 1, 0}, {20, 0, 0}}, 0.25);
  for (const DividingBridge& bridge : divided(strip, 60).bridges)
    EXPECT_LT((bridge.points.back() - bridge.points.front()).norm(), 1.5);
}

TEST(HoleSubdivision, FirstBisectionIsBalanced)
{
  for (const HolePolygon& hole : {capHole(100, 0.6), saddleHole(120)})
    for (const HolePolygon& part : divided(hole, hole.size() - 1).holes)
      EXPECT_LT(part.size(), 0.95 * static_cast<double>(hole.size()));
}

TEST(HoleSubdivision, FlatHoleStaysFlat)
{
  for (const Position& point : divided(combHole(3), 20).new_vertices)
    EXPECT_NEAR(0.0, point.z(), 1e-6);
}

TEST(HoleSubdivision, DoesNotDependOnScale)
{
  const DividedHole unit = divided(capHole(100, 0.6), 20);
  const DividedHole large = divided(capHole(100, 0.6, 1024.0), 20);
  ASSERT_EQ(unit.bridges.size(), large.bridges.size());
  for (std::size_t k = 0; k < unit.bridges.size(); ++k)
    EXPECT_EQ(unit.bridges[k].vertices, large.bridges[k].vertices);
}

TEST(HoleSubdivision, IsTheSameForAnyNumberOfThreads)
{
  for (const HolePolygon& hole : {saddleHole(120), combHole(3)}) {
    const DividedHole one = divided(hole, 12, 1);
    const DividedHole four = divided(hole, 12, 4);
    EXPECT_EQ(one.new_vertices, four.new_vertices);
    ASSERT_EQ(one.holes.size(), four.holes.size());
    for (std::size_t k = 0; k < one.holes.size(); ++k)
      EXPECT_EQ(one.holes[k].vertices, four.holes[k].vertices);
  }
}

TEST(HoleSubdivision, DegenerateHolesStayWhole)
{
  Positions line, place(30, Position(1, 2, 3));
  for (int k = 0; k < 30; ++k)
    line.emplace_back(k, 0, 0);
  for (const Positions& points : {line, place}) {
    const DividedHole parts = divided(test::contourOf(points, test::upward), 12);
    EXPECT_EQ(1U, parts.holes.size());
    EXPECT_TRUE(parts.bridges.empty());
  }
}

TEST(HoleSubdivision, TrianglesAreNeverDivided)
{
  EXPECT_EQ(1U, divided(capHole(3, 0.5), 0).holes.size());
}

TEST(HoleSubdivision, RandomContoursEnd)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    ccaa::test::RandomSource random(seed);
    Positions points;
    for (std::size_t k = 0; k < 40; ++k)
      points.emplace_back(random.normal(), random.normal(), random.normal());
    const HolePolygon hole = test::contourOf(points, test::upward);
    const DividedHole parts = divided(hole, 12);
    EXPECT_EQ(parts.bridges.size() + 1, parts.holes.size());
  }
}

TEST(HoleSubdivision, FreePointsPullBridges)
{
  const HolePolygon hole = capHole(60, 0.7);
  Positions samples;
  for (int x = -10; x <= 10; ++x)
    for (int y = -10; y <= 10; ++y)
      if (x * x + y * y < 90)
        samples.push_back(Position(0.06 * x, 0.06 * y, 0.9).normalized());
  const FreePointField field(samples, {0.06, 0.3, 1.0}, 0.5);
  SurveyParameters parameters;
  parameters.simple_edges = 20;
  const auto meanError = [&](const FreePointField* free_points) {
    const DividedHole parts =
        divideHole(hole, 60, parameters, {free_points, nullptr}, {});
    double sum = 0.0;
    for (const Position& point : parts.new_vertices)
      sum += std::abs(point.norm() - 1.0);
    return sum / static_cast<double>(parts.new_vertices.size());
  };
  EXPECT_LT(meanError(&field), 0.7 * meanError(nullptr));
}

TEST(HoleSubdivision, BridgesDoNotRunThroughTheSurface)
{
  // A wall across a round hole, with a way round it on both sides.
  IncompleteModel wall;
  wall.positions = {{0, -0.4, -1}, {0, 0.4, -1}, {0, 0.4, 2}, {0, -0.4, 2}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Shield shield(wall);
  SurveyParameters parameters;
  parameters.simple_edges = 40;
  const DividedHole parts =
      divideHole(capHole(80, 1.0), 80, parameters, {nullptr, &shield}, {});
  for (const DividingBridge& bridge : parts.bridges)
    for (std::size_t k = 1; k + 2 < bridge.points.size(); ++k)
      EXPECT_FALSE(shield.crosses(bridge.points[k], bridge.points[k + 1], 0.0));
}

} // namespace
} // namespace pcl::repair
