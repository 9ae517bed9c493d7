// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the front and the growing surface against plain searches.
#include <gtest/gtest.h>

#include "advancing_front/front.h"
#include "advancing_front/growing_surface.h"
#include "open_shapes.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::ccaa::test {
namespace {

using DirectedEdge = std::pair<index_t, index_t>;

bool
hasCorner(const Triangle& triangle, index_t vertex)
{
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

bool
runsThrough(const Triangle& triangle, DirectedEdge edge)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (triangle[i] == edge.first && triangle[(i + 1) % 3] == edge.second)
      return true;
  return false;
}

/** The directed edges that no triangle runs through the other way. */
std::set<DirectedEdge>
unmatchedEdges(const Triangles& triangles)
{
  std::set<DirectedEdge> all, unmatched;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      all.emplace(t[i], t[(i + 1) % 3]);
  for (const DirectedEdge& edge : all)
    if (all.count({edge.second, edge.first}) == 0)
      unmatched.insert(edge);
  return unmatched;
}

/** The unmatched edge out of the end of one, at the same fan. */
DirectedEdge
acrossTheFan(const Triangles& triangles, DirectedEdge edge)
{
  const index_t at = edge.second;
  index_t rim = edge.first;
  for (bool found = true; found;) {
    found = false;
    for (const Triangle& t : triangles)
      if (!found && runsThrough(t, {rim, at})) {
        rim = *std::find_if(t.begin(), t.end(), [&](index_t corner) {
          return corner != rim && corner != at;
        });
        found = true;
      }
  }
  return {at, rim};
}

std::vector<FrontIndex>
aliveEdges(const Front& front)
{
  std::vector<FrontIndex> alive;
  for (std::size_t i = 0; i < front.size(); ++i)
    if (front[static_cast<FrontIndex>(i)].alive)
      alive.push_back(static_cast<FrontIndex>(i));
  return alive;
}

/** Edges with an end among the open points; others are none of the front's business. */
std::set<DirectedEdge>
ofOpenPoints(std::set<DirectedEdge> edges, std::size_t open_points)
{
  for (auto edge = edges.begin(); edge != edges.end();)
    if (static_cast<std::size_t>(std::min(edge->first, edge->second)) >= open_points)
      edge = edges.erase(edge);
    else
      ++edge;
  return edges;
}

void
expectFrontOf(const GrowingSurface& surface, std::size_t open_points)
{
  const Front& front = surface.front();
  const Triangles& triangles = surface.triangles();
  std::set<DirectedEdge> edges;
  for (const FrontIndex i : aliveEdges(front)) {
    const FrontEdge& e = front[i];
    ASSERT_TRUE(edges.emplace(e.from, e.to).second) << "twice on the front";
    ASSERT_EQ(front.find(e.from, e.to), i);
    ASSERT_TRUE(front.contains(e.from));
    ASSERT_TRUE(std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      return runsThrough(t, {e.from, e.to}) && hasCorner(t, e.apex);
    }));
  }
  ASSERT_EQ(edges, ofOpenPoints(unmatchedEdges(triangles), open_points));
}

void
expectLoopsStayAtTheirFans(const GrowingSurface& surface, std::size_t open_points)
{
  const Front& front = surface.front();
  for (const FrontIndex i : aliveEdges(front)) {
    const FrontEdge& e = front[i];
    if (static_cast<std::size_t>(e.to) >= open_points)
      continue;
    ASSERT_NE(e.next, FrontEdge::NONE);
    ASSERT_TRUE(front[e.next].alive);
    ASSERT_EQ(front[e.next].previous, i);
    ASSERT_EQ(std::make_pair(front[e.next].from, front[e.next].to),
              acrossTheFan(surface.triangles(), {e.from, e.to}));
  }
}

/** One random step: a triangle on a front edge, or a new beginning. */
bool
growAtRandom(GrowingSurface& surface, std::size_t open_points, RandomSource& random)
{
  const std::vector<FrontIndex> alive = aliveEdges(surface.front());
  const auto anyPoint = [&] { return static_cast<index_t>(random.below(open_points)); };
  if (alive.empty() || random.uniform() < 0.02) {
    const Triangle seed{anyPoint(), anyPoint(), anyPoint()};
    if (seed[0] == seed[1] || seed[1] == seed[2] || seed[2] == seed[0] ||
        surface.hasTriangles(seed[0]) || surface.hasTriangles(seed[1]) ||
        surface.hasTriangles(seed[2]))
      return false;
    surface.addTriangle(seed);
    return true;
  }
  const FrontIndex i = alive[random.below(alive.size())];
  const FrontEdge edge = surface.front()[i];
  index_t apex = anyPoint();
  if (random.uniform() < 0.5 && edge.next != FrontEdge::NONE)
    apex = surface.front()[edge.next].to; // else hardly any loop would close
  if (std::max(edge.from, edge.to) >= static_cast<index_t>(open_points) ||
      apex >= static_cast<index_t>(open_points) || apex == edge.from ||
      apex == edge.to || apex == edge.apex || !surface.isOpen(apex) ||
      !surface.takesEdge(edge.from, apex) || !surface.takesEdge(apex, edge.to))
    return false;
  surface.advance(i, apex);
  return true;
}

/** Surfaces grown at random, from points alone or from the rim of a partial mesh. */
template <typename Check>
void
forRandomGrowth(Check check)
{
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const OpenSurface open =
        seed % 2 == 0
            ? openPoints(randomPositions(12 + 2 * seed, seed), 6)
            : openSurfaceOf(withoutRandomTriangles(icosphere(2), 0.15, seed), 6);
    GrowingSurface surface(open);
    RandomSource random(seed);
    check(surface, open.open_points);
    int steps = 0;
    for (int tries = 0; tries < 600 && !::testing::Test::HasFatalFailure(); ++tries)
      if (growAtRandom(surface, open.open_points, random) && ++steps % 3 == 0)
        check(surface, open.open_points);
    check(surface, open.open_points);
    ASSERT_GE(steps, 10);
  }
}

TEST(Front, HoldsTheEdgesThatHaveOneTriangle)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    expectFrontOf(surface, open_points);
  });
}

TEST(Front, FollowsTheFanAtEveryCorner)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    expectLoopsStayAtTheirFans(surface, open_points);
  });
}

TEST(Front, ListsTheEdgesFromAVertex)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    const std::set<DirectedEdge> edges =
        ofOpenPoints(unmatchedEdges(surface.triangles()), open_points);
    for (index_t v = 0; v < static_cast<index_t>(open_points); ++v) {
      std::multiset<index_t> expected, actual;
      for (const DirectedEdge& edge : edges)
        if (edge.first == v)
          expected.insert(edge.second);
      surface.front().forEdgesFrom(
          v, [&](FrontIndex i) { actual.insert(surface.front()[i].to); });
      ASSERT_EQ(actual, expected);
      ASSERT_EQ(surface.front().contains(v), !expected.empty());
    }
  });
}

TEST(Front, OfAClosedTetrahedronIsEmpty)
{
  Front front(4);
  front.addTriangle({0, 2, 1});
  front.advance(front.find(0, 2), 3);
  front.advance(front.find(2, 1), 3);
  EXPECT_TRUE(front.contains(3));
  front.advance(front.find(1, 0), 3);
  EXPECT_TRUE(aliveEdges(front).empty());
  for (index_t v = 0; v < 4; ++v)
    EXPECT_FALSE(front.contains(v));
}

TEST(Front, HasTwoLoopsAtAPointThatTwoFansTouch)
{
  Front front(5);
  front.addTriangle({0, 1, 2});
  front.addTriangle({0, 3, 4});
  int from_zero = 0;
  front.forEdgesFrom(0, [&](FrontIndex i) {
    ++from_zero;
    const FrontEdge& into = front[front[i].previous];
    EXPECT_EQ(into.to, 0);
    EXPECT_EQ(into.from, front[i].apex); // of the same triangle
  });
  EXPECT_EQ(from_zero, 2);
}

TEST(Front, NumbersAreNotUsedAgain)
{
  Front front(5);
  front.addTriangle({0, 1, 2});
  const FrontIndex edge = front.find(0, 1);
  front.advance(edge, 3);
  EXPECT_FALSE(front[edge].alive);
  EXPECT_EQ(front.find(0, 1), FrontEdge::NONE);
  EXPECT_EQ(front.size(), 5u);
}

TEST(GrowingSurface, KnowsItsEdges)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    for (index_t one = 0; one < static_cast<index_t>(open_points); one += 13)
      for (index_t other = 0; other < static_cast<index_t>(open_points); ++other) {
        if (one == other)
          continue;
        const Triangles& triangles = surface.triangles();
        const bool expected =
            std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
              return hasCorner(t, one) && hasCorner(t, other);
            });
        ASSERT_EQ(surface.hasEdge(one, other), expected);
      }
  });
}

TEST(GrowingSurface, TakesATriangleWhereAnEdgeIsNewOrHasOneTheOtherWay)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    const std::set<DirectedEdge> unmatched = unmatchedEdges(surface.triangles());
    for (index_t from = 0; from < static_cast<index_t>(open_points); from += 7)
      for (index_t to = 0; to < static_cast<index_t>(open_points); ++to)
        if (from != to) {
          ASSERT_EQ(surface.takesEdge(from, to),
                    unmatched.count({to, from}) != 0 || !surface.hasEdge(from, to));
        }
  });
}

TEST(GrowingSurface, IsOpenWhereThereIsNoTriangleOrABorder)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t open_points) {
    const std::set<DirectedEdge> unmatched = unmatchedEdges(surface.triangles());
    for (index_t v = 0; v < static_cast<index_t>(open_points); ++v) {
      std::size_t at = 0;
      surface.forTrianglesAt(v, [&](index_t t) {
        ++at;
        ASSERT_TRUE(hasCorner(surface.triangles()[std::size_t(t)], v));
      });
      ASSERT_EQ(surface.hasTriangles(v), at > 0);
      const bool on_border = std::any_of(unmatched.begin(),
                                         unmatched.end(),
                                         [&](const auto& e) { return e.first == v; });
      ASSERT_EQ(surface.isOpen(v), at == 0 || on_border);
    }
  });
}

TEST(GrowingSurface, HasNoEdgeThatTwoTrianglesRunThroughAlike)
{
  forRandomGrowth([](const GrowingSurface& surface, std::size_t) {
    ASSERT_TRUE(isConsistentlyWound(surface.triangles()));
  });
}

TEST(GrowingSurface, WeighsNormalsByAngle)
{
  const OpenSurface open = openPoints(tetrahedron().vertices, 6);
  GrowingSurface surface(open);
  surface.addTriangle({0, 1, 2});
  EXPECT_TRUE(surface.normalSum(0).isApprox(Position(0, 0, M_PI / 2)));
  EXPECT_TRUE(surface.normalSum(1).isApprox(Position(0, 0, M_PI / 4)));
  EXPECT_TRUE(surface.normalSum(3).isZero());
}

} // namespace
} // namespace pcl::ccaa::test
