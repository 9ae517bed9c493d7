// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of holes as polygons of vertices.

#include <gtest/gtest.h>

#include "hole/hole_polygon.h"
#include "surface_repair/force_line/sphere_rims.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {
namespace {

using test::sphereRim;

constexpr std::size_t COUNT = 48;
constexpr pcl::index_t MODEL_VERTICES = 2 * COUNT;

using VertexPair = std::pair<pcl::index_t, pcl::index_t>;

/** The rims of two caps, bridges between them, and the holes that this makes. Point k
 * of the upper rim is vertex k of the model, those of the lower rim follow. */
struct Belt {
  explicit Belt(std::size_t bridge_count, std::size_t inner_points = 2)
  : boundaries({{sphereRim(0.3, true, COUNT), 0}, {sphereRim(-0.3, false, COUNT), 1}})
  {
    for (std::size_t c = 0; c < 2; ++c) {
      vertices.of_curve.emplace_back();
      for (std::size_t k = 0; k < COUNT; ++k)
        vertices.of_curve[c].push_back(static_cast<pcl::index_t>(c * COUNT + k));
    }
    pcl::index_t next = MODEL_VERTICES;
    for (std::size_t b = 0; b < bridge_count; ++b) {
      const std::size_t upper = b * COUNT / bridge_count;
      bridges.push_back(bridgeBetween(upper, (COUNT - upper) % COUNT, inner_points));
      vertices.first_inner.push_back(next);
      next += static_cast<pcl::index_t>(inner_points);
    }
    contours = extractContours(boundaries, bridges).contours;
  }

  BoundaryPoint
  supportAt(std::size_t curve, std::size_t vertex) const
  {
    BoundaryPoint point;
    point.curve = curve;
    point.edge = vertex;
    point.position = boundaries.curves()[curve].curve.points[vertex];
    return point;
  }

  Bridge
  bridgeBetween(std::size_t upper, std::size_t lower, std::size_t inner_points) const
  {
    Bridge bridge;
    bridge.begin = supportAt(0, upper);
    bridge.end = supportAt(1, lower);
    for (std::size_t k = 0; k < inner_points + 2; ++k) {
      const double share =
          static_cast<double>(k) / static_cast<double>(inner_points + 1);
      const Position point =
          (1.0 - share) * bridge.begin.position + share * bridge.end.position;
      bridge.points.push_back(point);
      bridge.normals.push_back(point.normalized());
    }
    bridge.points.back() = bridge.end.position;
    return bridge;
  }

  std::vector<HolePolygon>
  polygons() const
  {
    std::vector<HolePolygon> all;
    for (const HoleContour& contour : contours)
      all.push_back(polygonOf(contour, boundaries, bridges, vertices));
    return all;
  }

  BoundaryEdges boundaries;
  std::vector<Bridge> bridges;
  ContourVertices vertices;
  std::vector<HoleContour> contours;
};

/** How often the polygons run over each pair of vertices, in its direction. */
std::map<VertexPair, int>
directedEdges(const std::vector<HolePolygon>& polygons)
{
  std::map<VertexPair, int> edges;
  for (const HolePolygon& polygon : polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k)
      ++edges[{polygon.vertices[k], polygon.vertices[polygon.curve.next(k)]}];
  return edges;
}

/** The edges of both rims, in positive direction. */
std::set<VertexPair>
rimEdges()
{
  std::set<VertexPair> edges;
  for (pcl::index_t c = 0; c < 2; ++c)
    for (pcl::index_t k = 0; k < static_cast<pcl::index_t>(COUNT); ++k) {
      const auto count = static_cast<pcl::index_t>(COUNT);
      edges.emplace(c * count + k, c * count + (k + 1) % count);
    }
  return edges;
}

TEST(HolePolygon, EachBoundaryEdgeAppearsOnceAndForward)
{
  const std::map<VertexPair, int> edges = directedEdges(Belt(5).polygons());
  for (const VertexPair& edge : rimEdges()) {
    EXPECT_EQ(1U, edges.count(edge)) << edge.first;
    EXPECT_EQ(0U, edges.count({edge.second, edge.first})) << edge.first;
  }
}

TEST(HolePolygon, EachBridgeEdgeAppearsOnceInEachDirection)
{
  const std::map<VertexPair, int> edges = directedEdges(Belt(5).polygons());
  const std::set<VertexPair> rims = rimEdges();
  std::size_t of_bridges = 0;
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(1, times);
    if (rims.count(edge) == 0) {
      EXPECT_EQ(1U, edges.count({edge.second, edge.first})) << edge.first;
      ++of_bridges;
    }
  }
  EXPECT_EQ(2U * 5U * 3U, of_bridges);
}

TEST(HolePolygon, BridgesWithoutInnerPointsAreSingleEdges)
{
  std::size_t points = 0;
  for (const HolePolygon& polygon : Belt(4, 0).polygons())
    points += polygon.size();
  EXPECT_EQ(2U * COUNT + 2U * 4U, points); // each supporting point is in two
}

TEST(HolePolygon, VerticesAreAllDifferent)
{
  for (const HolePolygon& polygon : Belt(5).polygons())
    EXPECT_EQ(polygon.size(),
              std::set<pcl::index_t>(polygon.vertices.begin(), polygon.vertices.end())
                  .size());
}

TEST(HolePolygon, AVertexHasTheSamePlaceInAllPolygons)
{
  std::map<pcl::index_t, Position> places;
  for (const HolePolygon& polygon : Belt(5).polygons())
    for (std::size_t k = 0; k < polygon.size(); ++k)
      EXPECT_EQ(
          places.emplace(polygon.vertices[k], polygon.curve.points[k]).first->second,
          polygon.curve.points[k]);
  EXPECT_EQ(2U * COUNT + 5U * 2U, places.size());
}

TEST(HolePolygon, InnerPointsOfABridgeAreNumberedFromItsBegin)
{
  const Belt belt(5);
  for (const HolePolygon& polygon : belt.polygons())
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      if (polygon.vertices[k] < MODEL_VERTICES)
        continue;
      const auto inner = static_cast<std::size_t>(polygon.vertices[k] - MODEL_VERTICES);
      EXPECT_EQ(belt.bridges[inner / 2].points[inner % 2 + 1], polygon.curve.points[k]);
    }
}

TEST(HolePolygon, OnABoundaryItHasTheNormalsOfTheBoundary)
{
  const Belt belt(5);
  const std::set<VertexPair> rims = rimEdges();
  for (const HolePolygon& polygon : belt.polygons())
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const pcl::index_t v = polygon.vertices[k];
      if (rims.count({v, polygon.vertices[polygon.curve.next(k)]}) == 0)
        continue;
      const auto place = static_cast<std::size_t>(v);
      EXPECT_EQ(belt.boundaries.curves()[place / COUNT].curve.normals[place % COUNT],
                polygon.curve.normals[k]);
    }
}

TEST(HolePolygon, OnABridgeItHasTheMeanNormalOfTheEdgesEnds)
{
  const std::set<VertexPair> rims = rimEdges();
  for (const HolePolygon& polygon : Belt(5).polygons())
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t next = polygon.curve.next(k);
      if (rims.count({polygon.vertices[k], polygon.vertices[next]}) > 0)
        continue;
      const Direction mean = polygon.curve.points[k].normalized() +
                             polygon.curve.points[next].normalized();
      EXPECT_LT((mean.normalized() - polygon.curve.normals[k]).norm(), 1e-12);
    }
}

TEST(HolePolygon, HasOneNormalAnEdge)
{
  for (const HolePolygon& polygon : Belt(3).polygons()) {
    EXPECT_EQ(polygon.size(), polygon.curve.points.size());
    EXPECT_EQ(polygon.size(), polygon.curve.normals.size());
  }
}

TEST(HolePolygon, OfABoundaryWithoutBridgesIsThatBoundary)
{
  const Belt belt(0);
  const std::vector<HolePolygon> polygons = belt.polygons();
  ASSERT_EQ(2U, polygons.size());
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(belt.vertices.of_curve[c], polygons[c].vertices);
    EXPECT_EQ(belt.boundaries.curves()[c].curve.points, polygons[c].curve.points);
    EXPECT_EQ(belt.boundaries.curves()[c].curve.normals, polygons[c].curve.normals);
  }
}

TEST(HolePolygon, OfALoopIsThatLoop)
{
  BoundaryLoop loop;
  loop.curve = sphereRim(0.2, true, 7);
  loop.vertices = {5, 9, 1, 0, 2, 3, 4};
  const HolePolygon polygon = polygonOf(loop);
  EXPECT_EQ(loop.vertices, polygon.vertices);
  EXPECT_EQ(loop.curve.points, polygon.curve.points);
}

} // namespace
} // namespace pcl::repair
