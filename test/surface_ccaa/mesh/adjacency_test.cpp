// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the unoriented triangle adjacency.
#include <gtest/gtest.h>

#include "mesh/triangle_adjacency.h"
#include "run/run_control.h"
#include "support/shapes.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace pcl::ccaa::test {
namespace {

using Edge = TriangleAdjacency::Edge;

Edge
edgeOf(const Triangle& triangle, std::size_t corner)
{
  Edge edge{triangle[corner], triangle[(corner + 1) % 3]};
  std::sort(edge.begin(), edge.end());
  return edge;
}

/** \brief The plain way: all triangles of each edge. */
std::map<Edge, std::vector<pcl::index_t>>
edgeMap(const Triangles& triangles)
{
  std::map<Edge, std::vector<pcl::index_t>> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner)
      edges[edgeOf(triangles[i], corner)].push_back(static_cast<pcl::index_t>(i));
  return edges;
}

/** \brief The plain way: merge triangles at a vertex that share an edge there. */
Fan
fanOf(const std::map<Edge, std::vector<pcl::index_t>>& edges, pcl::index_t vertex)
{
  std::map<pcl::index_t, pcl::index_t> group;
  bool open = false;
  for (const auto& [edge, wings] : edges)
    if (edge[0] == vertex || edge[1] == vertex) {
      if (wings.size() > 2)
        return Fan::OVERFULL;
      open = open || wings.size() == 1;
      for (const auto wing : wings)
        group.emplace(wing, wing);
    }
  if (group.empty())
    return Fan::NONE;
  for (std::size_t round = 0; round < group.size(); ++round)
    for (const auto& [edge, wings] : edges)
      if ((edge[0] == vertex || edge[1] == vertex) && wings.size() == 2)
        group[wings[0]] = group[wings[1]] = std::min(group[wings[0]], group[wings[1]]);
  std::set<pcl::index_t> groups;
  for (const auto& [wing, lowest] : group)
    groups.insert(lowest);
  if (groups.size() > 1 || (!open && group.size() == 2))
    return Fan::SEVERAL;
  return open ? Fan::OPEN : Fan::CLOSED;
}

void
expectMatches(const TriangleAdjacency& adjacency,
              const Triangles& triangles,
              std::size_t vertex_count)
{
  ASSERT_EQ(adjacency.vertexCount(), vertex_count);
  ASSERT_EQ(adjacency.triangleCount(), triangles.size());
  const auto edges = edgeMap(triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto triangle = static_cast<pcl::index_t>(i);
      const auto& wings = edges.at(edgeOf(triangles[i], corner));
      const auto expected = wings.size() == 1      ? TriangleAdjacency::NONE
                            : wings.size() > 2     ? TriangleAdjacency::OVERFULL
                            : wings[0] == triangle ? wings[1]
                                                   : wings[0];
      ASSERT_EQ(adjacency.across(triangle, static_cast<int>(corner)), expected);
    }
  std::vector<std::vector<pcl::index_t>> incident(vertex_count);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const auto vertex : triangles[i])
      incident[static_cast<std::size_t>(vertex)].push_back(
          static_cast<pcl::index_t>(i));
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const auto vertex = static_cast<pcl::index_t>(i);
    const std::vector<pcl::index_t> actual(adjacency.begin(vertex),
                                           adjacency.end(vertex));
    ASSERT_EQ(actual, incident[i]);
    ASSERT_EQ(adjacency.fan(vertex), fanOf(edges, vertex)) << "vertex " << i;
  }
}

void
expectOverfullListed(const TriangleAdjacency& adjacency, const Triangles& triangles)
{
  std::size_t place = 0;
  for (const auto& [edge, wings] : edgeMap(triangles)) {
    if (wings.size() < 3)
      continue;
    ASSERT_LT(place, adjacency.overfullEdges().size());
    ASSERT_EQ(adjacency.overfullEdges()[place], edge);
    const std::vector<pcl::index_t> listed(adjacency.beginOverfull(place),
                                           adjacency.endOverfull(place));
    ASSERT_EQ(listed, wings);
    ++place;
  }
  ASSERT_EQ(place, adjacency.overfullEdges().size());
}

/** \brief Random triangles with different corners; may hold a triangle twice. */
Triangles
soup(std::size_t count, int vertex_count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<pcl::index_t> vertex(0, vertex_count - 1);
  Triangles triangles;
  while (triangles.size() < count) {
    const Triangle triangle{vertex(random), vertex(random), vertex(random)};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
        triangle[2] != triangle[0])
      triangles.push_back(triangle);
  }
  return triangles;
}

/** \brief A disc around vertex 0 with many triangles. */
Triangles
disc(pcl::index_t corners, bool closed)
{
  Triangles triangles;
  for (pcl::index_t i = 1; i < corners; ++i)
    triangles.push_back({0, i, i + 1});
  if (closed)
    triangles.push_back({corners, 0, 1});
  return triangles;
}

TEST(TriangleAdjacency, MatchesNamedShapes)
{
  for (const auto& shape : {tetrahedron(),
                            icosphere(1),
                            torus(7, 5),
                            grid(6, 5),
                            moebiusBand(7),
                            bowTie(),
                            twoFansAtApex(),
                            threeOnEdge()}) {
    TriangleAdjacency adjacency;
    const auto triangles = randomlyReversed(shape.triangles, 5);
    adjacency.build(triangles, shape.vertices.size());
    expectMatches(adjacency, triangles, shape.vertices.size());
    expectOverfullListed(adjacency, triangles);
  }
}

TEST(TriangleAdjacency, MatchesFansOfAnySize)
{
  for (const bool closed : {false, true})
    for (pcl::index_t corners = 3; corners < 40; ++corners) {
      const auto triangles = disc(corners, closed);
      TriangleAdjacency adjacency;
      adjacency.build(triangles, static_cast<std::size_t>(corners) + 1);
      expectMatches(adjacency, triangles, static_cast<std::size_t>(corners) + 1);
      EXPECT_EQ(adjacency.fan(0), closed ? Fan::CLOSED : Fan::OPEN);
    }
}

TEST(TriangleAdjacency, SeesTwoLargeFansAtOneVertex)
{
  for (const pcl::index_t corners : {4, 8, 9, 20}) {
    auto triangles = disc(corners, true);
    for (auto triangle : disc(corners, true)) {
      for (auto& corner : triangle)
        corner += corner == 0 ? 0 : corners;
      triangles.push_back(triangle);
    }
    TriangleAdjacency adjacency;
    adjacency.build(triangles, 2 * static_cast<std::size_t>(corners) + 1);
    EXPECT_EQ(adjacency.fan(0), Fan::SEVERAL);
  }
}

TEST(TriangleAdjacency, MatchesRandomSoupOfAnyDensity)
{
  for (unsigned int seed = 0; seed < 60; ++seed) {
    const int vertex_count = 4 + static_cast<int>(seed % 20);
    const auto triangles = soup(1 + seed * 2, vertex_count, seed);
    TriangleAdjacency adjacency;
    adjacency.build(triangles, static_cast<std::size_t>(vertex_count));
    expectMatches(adjacency, triangles, static_cast<std::size_t>(vertex_count));
    expectOverfullListed(adjacency, triangles);
  }
}

TEST(TriangleAdjacency, IsTheSameForAnyNumberOfThreads)
{
  const std::size_t vertex_count = 60000;
  const auto triangles = soup(150000, static_cast<int>(vertex_count), 3);
  TriangleAdjacency one;
  one.build(triangles, vertex_count, 1);
  for (const int threads : {2, 7}) {
    TriangleAdjacency many;
    many.build(triangles, vertex_count, threads);
    EXPECT_EQ(one.fans(), many.fans());
    EXPECT_EQ(one.overfullEdges(), many.overfullEdges());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (int corner = 0; corner < 3; ++corner)
        ASSERT_EQ(one.across(static_cast<pcl::index_t>(i), corner),
                  many.across(static_cast<pcl::index_t>(i), corner));
  }
}

TEST(TriangleAdjacency, FollowsDeletionAsIfBuiltAnew)
{
  const auto shape = icosphere(2);
  std::vector<std::uint8_t> alive(shape.triangles.size(), 1);
  Triangles kept;
  for (std::size_t i = 0; i < alive.size(); ++i) {
    alive[i] = i % 5 != 0 ? 1 : 0;
    if (alive[i] != 0)
      kept.push_back(shape.triangles[i]);
  }
  for (const int threads : {1, 3}) {
    TriangleAdjacency adjacency;
    adjacency.build(shape.triangles, shape.vertices.size());
    adjacency.follow(alive, kept, shape.vertices.size(), threads);
    expectMatches(adjacency, kept, shape.vertices.size());
  }
}

TEST(TriangleAdjacency, FollowsTurnedTrianglesAsIfBuiltAnew)
{
  Shape shape = joined(threeOnEdge(), grid(5, 4));
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
    const Triangle before = shape.triangles[t];
    adjacency.turn(static_cast<pcl::index_t>(t), shape.triangles);
    EXPECT_EQ((Triangle{before[0], before[2], before[1]}), shape.triangles[t]);
  }
  expectMatches(adjacency, shape.triangles, shape.vertices.size());
}

TEST(TriangleAdjacency, FollowsAppendedTrianglesAsIfBuiltAnew)
{
  const auto shape = icosphere(2);
  const std::size_t more_vertices = shape.vertices.size() + 5;
  for (unsigned int seed = 0; seed < 30; ++seed) {
    Triangles all, gaps;
    for (std::size_t i = 0; i < shape.triangles.size(); ++i)
      (i % 11 == seed % 11 ? gaps : all).push_back(shape.triangles[i]);
    TriangleAdjacency adjacency;
    adjacency.build(all, shape.vertices.size());
    const auto wild = soup(seed % 7, static_cast<int>(more_vertices), seed);
    all.insert(all.end(), wild.begin(), wild.end());
    all.insert(all.end(), gaps.begin(), gaps.end());
    adjacency.follow({}, all, more_vertices);
    expectMatches(adjacency, all, more_vertices);
    expectOverfullListed(adjacency, all);
    all.push_back({0, 1, 2}); // there may be overfull edges now
    adjacency.follow({}, all, more_vertices);
    expectMatches(adjacency, all, more_vertices);
  }
}

TEST(TriangleAdjacency, FollowsDeletedAndAppendedTrianglesAsIfBuiltAnew)
{
  const auto shape = icosphere(2);
  for (const std::size_t appended : {0U, 3U, 200U}) {
    Triangles before(shape.triangles.begin() + std::ptrdiff_t(appended),
                     shape.triangles.end());
    std::vector<std::uint8_t> alive(before.size(), 1);
    Triangles after;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (alive[i] = i % 9 != 0; alive[i] != 0)
        after.push_back(before[i]);
    after.insert(after.end(),
                 shape.triangles.begin(),
                 shape.triangles.begin() + std::ptrdiff_t(appended));
    TriangleAdjacency adjacency;
    adjacency.build(before, shape.vertices.size());
    adjacency.follow(alive, after, shape.vertices.size());
    expectMatches(adjacency, after, shape.vertices.size());
  }
}

TEST(TriangleAdjacency, FollowsNewNumbersOfVerticesAsIfBuiltAnew)
{
  auto shape = icosphere(2);
  const std::size_t count = shape.vertices.size();
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, count + 2); // two have no triangle
  std::vector<pcl::index_t> before(count);
  for (std::size_t v = 0; v < count; ++v)
    before[v] = static_cast<pcl::index_t>(count - 1 - v);
  for (Triangle& triangle : shape.triangles)
    for (pcl::index_t& corner : triangle)
      corner = static_cast<pcl::index_t>(count) - 1 - corner;
  before.resize(count + 5, -1);
  adjacency.renumber(before);
  expectMatches(adjacency, shape.triangles, count + 5);
}

TEST(TriangleAdjacency, FollowsMoreTrianglesThanThereWere)
{
  const auto shape = icosphere(2);
  const Triangles few(shape.triangles.begin(), shape.triangles.begin() + 3);
  TriangleAdjacency adjacency;
  adjacency.follow({}, few, shape.vertices.size());
  adjacency.follow({}, shape.triangles, shape.vertices.size());
  expectMatches(adjacency, shape.triangles, shape.vertices.size());
}

TEST(TriangleAdjacency, HoldsNothing)
{
  TriangleAdjacency adjacency;
  EXPECT_EQ(adjacency.vertexCount(), 0u);
  adjacency.build({}, 3);
  EXPECT_EQ(adjacency.vertexCount(), 3u);
  EXPECT_EQ(adjacency.triangleCount(), 0u);
  EXPECT_EQ(adjacency.begin(2), adjacency.end(2));
  EXPECT_EQ(adjacency.fan(1), Fan::NONE);
  adjacency.build({}, 0);
  EXPECT_EQ(adjacency.vertexCount(), 0u);
}

TEST(TriangleAdjacency, IsEmptyWhenCancelled)
{
  RunControl control([](const std::string&, double) { return false; });
  const auto shape = icosphere(1);
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size(), 1, &control);
  EXPECT_EQ(adjacency.triangleCount(), 0u);
  EXPECT_EQ(adjacency.vertexCount(), 0u);
}

} // namespace
} // namespace pcl::ccaa::test
