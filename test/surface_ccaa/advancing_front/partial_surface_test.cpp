// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: given and new triangles, and one fan for every point.
#include <gtest/gtest.h>

#include "advancing_front/fan_settlement.h"
#include "advancing_front/partial_surface.h"
#include "advancing_front/spacing.h"
#include "open_shapes.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::ccaa::test {
namespace {

std::vector<index_t>
trianglesAtVertex(const PartialSurface& surface, index_t vertex)
{
  std::vector<index_t> found;
  surface.forTrianglesAt(vertex, [&](index_t t) { found.push_back(t); });
  return found;
}

TEST(PartialSurface, NumbersNewTrianglesAfterTheGivenOnes)
{
  PartialShape partial(tetrahedron());
  partial.surface.add({0, 1, 2});
  EXPECT_EQ(partial.surface.triangleCount(), 5u);
  EXPECT_TRUE(partial.surface.isGiven(3));
  EXPECT_FALSE(partial.surface.isGiven(4));
  EXPECT_EQ(partial.surface[4], (Triangle{0, 1, 2}));
}

TEST(PartialSurface, ListsTrianglesAtAVertexGivenOnesFirst)
{
  PartialShape partial(tetrahedron());
  partial.surface.add({0, 1, 2});
  partial.surface.add({0, 2, 3});
  EXPECT_EQ(trianglesAtVertex(partial.surface, 0),
            (std::vector<index_t>{0, 1, 2, 5, 4}));
  EXPECT_EQ(trianglesAtVertex(partial.surface, 1), (std::vector<index_t>{0, 1, 3, 4}));
}

TEST(PartialSurface, LeavesOutWhatIsRemoved)
{
  PartialShape partial(tetrahedron());
  partial.surface.add({0, 1, 2});
  partial.surface.remove(1);
  partial.surface.remove(4);
  EXPECT_EQ(trianglesAtVertex(partial.surface, 0), (std::vector<index_t>{0, 2}));
  EXPECT_FALSE(partial.surface.isAlive(1));
  EXPECT_EQ(partial.surface.aliveGiven(), (AliveFlags{1, 0, 1, 1}));
}

TEST(PartialSurface, ListsTrianglesAtSeveralVerticesOnce)
{
  PartialShape partial(tetrahedron());
  EXPECT_EQ(partial.surface.trianglesAt({3, 0}), (std::vector<index_t>{0, 1, 2, 3}));
  EXPECT_EQ(partial.surface.trianglesAt({1}), (std::vector<index_t>{0, 1, 3}));
}

double
largestRoomOf(const Shape& shape)
{
  const PartialShape partial(shape);
  return largestRoom(partial.surface, shape.triangles, PointView(shape.vertices));
}

TEST(PartialSurface, TellsWhereItEnds)
{
  PartialShape partial(tetrahedron());
  const auto isBorderAnywhere = [&] {
    return partial.surface.isBorder(0) || partial.surface.isBorder(1) ||
           partial.surface.isBorder(2) || partial.surface.isBorder(3);
  };
  EXPECT_FALSE(isBorderAnywhere());
  const Triangle gone = partial.surface[1];
  partial.surface.remove(1);
  for (index_t v = 0; v < 4; ++v)
    EXPECT_EQ(partial.surface.isBorder(v),
              std::find(gone.begin(), gone.end(), v) != gone.end());
  partial.surface.add(gone);
  EXPECT_FALSE(isBorderAnywhere());
}

TEST(LargestRoom, IsOneAndAHalfSpacingsOnAGrid)
{
  EXPECT_EQ(largestRoomOf(icosphere(4)), 1.5);
  EXPECT_EQ(largestRoomOf(torus(60, 30)), 1.5);
}

TEST(LargestRoom, IsMoreWhereSamplesAreMovedAtRandom)
{
  Shape floor = grid(41, 41);
  RandomSource random(1);
  for (Position& vertex : floor.vertices)
    vertex += Position(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0.0);
  EXPECT_GT(largestRoomOf(floor), 1.6);
}

TEST(LargestRoom, IsNeverMoreThanRandomSamplesLeave)
{
  Shape ball = icosphere(4);
  RandomSource random(1);
  for (Position& vertex : ball.vertices)
    vertex *= std::exp(3.0 * random.normal());
  EXPECT_EQ(largestRoomOf(ball), 2.5);
}

TEST(LargestRoom, IsKeptInEveryPartOfTheSurface)
{
  PartialShape partial(icosphere(2));
  partial.surface.setLargestRoom(2.25);
  std::vector<index_t> vertices;
  EXPECT_EQ(partial.surface.openAt({3, 5}, {}, vertices).largest_room, 2.25);
}

/** The open surface speaks of the same places and triangles as the whole. */
TEST(PartialSurface, OpensUpAroundVerticesInTheirOrder)
{
  PartialShape partial(withoutPatches(icosphere(3), 3, 1, 4));
  std::vector<index_t> open = partial.openVertices(), vertices;
  RandomSource(1).shuffle(open);
  const OpenSurface around = partial.surface.openAt(open, {}, vertices);
  ASSERT_EQ(around.open_points, open.size());
  EXPECT_TRUE(std::equal(open.begin(), open.end(), vertices.begin()));
  ASSERT_EQ(around.positions.size(), vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    EXPECT_EQ(around.positions[v], partial.shape.vertices[std::size_t(vertices[v])]);
  Triangles rim = around.rim, expected;
  for (Triangle& t : rim)
    for (index_t& corner : t)
      corner = vertices[std::size_t(corner)];
  for (const index_t t : partial.surface.trianglesAt(open))
    expected.push_back(partial.shape.triangles[std::size_t(t)]);
  EXPECT_EQ(rim, expected);
}

TEST(PartialSurface, NumbersEveryVertexOnce)
{
  PartialShape partial(withoutPatches(icosphere(3), 3, 1, 4));
  std::vector<index_t> vertices;
  partial.surface.openAt(partial.openVertices(), {}, vertices);
  std::sort(vertices.begin(), vertices.end());
  EXPECT_EQ(std::adjacent_find(vertices.begin(), vertices.end()), vertices.end());
}

TEST(PartialSurface, LeavesTrianglesOutOfTheRimOnRequest)
{
  PartialShape partial(tetrahedron());
  std::vector<index_t> vertices;
  const OpenSurface around = partial.surface.openAt({0}, {1, 2}, vertices);
  EXPECT_EQ(around.rim.size(), 1u);
  std::sort(vertices.begin(), vertices.end());
  EXPECT_EQ(vertices, (std::vector<index_t>{0, 1, 2}));
}

TEST(PartialSurface, OpensUpTheSameWayTwice)
{
  PartialShape partial(withoutPatches(icosphere(2), 2, 1, 4));
  std::vector<index_t> first, second;
  const OpenSurface one = partial.surface.openAt(partial.openVertices(), {}, first);
  const OpenSurface other = partial.surface.openAt(partial.openVertices(), {}, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(one.rim, other.rim);
}

TEST(PartialSurface, KnowsTheSpacingFromGivenTrianglesAlsoWhenTheyAreRemoved)
{
  PartialShape partial(grid(5, 5));
  std::vector<index_t> vertices;
  for (index_t t = 0; t < 32; ++t)
    partial.surface.remove(t);
  EXPECT_DOUBLE_EQ(partial.surface.openAt({2}, {}, vertices).spacings[0], 1.0);
}

TEST(PartialSurface, KnowsTheSpacingThatWasNoted)
{
  PartialShape partial({grid(3, 3).vertices, {}});
  std::vector<index_t> vertices;
  EXPECT_EQ(partial.surface.openAt({4}, {}, vertices).spacings[0], 0.0);
  partial.surface.noteSpacing(4, 0.25);
  EXPECT_EQ(partial.surface.openAt({4}, {}, vertices).spacings[0], 0.25);
}

TEST(OpenSurface, NeighborsAscendByDistanceThenNumber)
{
  Positions points = randomPositions(60, 3);
  const Positions lattice = grid(5, 5).vertices; // with ties
  points.insert(points.end(), lattice.begin(), lattice.end());
  const OpenSurface open = openPoints(points, 12);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::pair<double, index_t>> all;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i)
        all.emplace_back((points[i] - points[j]).squaredNorm(),
                         static_cast<index_t>(j));
    std::sort(all.begin(), all.end());
    for (unsigned int place = 0; place < 12; ++place)
      ASSERT_EQ(open.neighbors.row(static_cast<index_t>(i))[place], all[place].second);
  }
}

TEST(OpenSurface, RowsEndEarlyWhereThereAreFewPoints)
{
  const OpenSurface open = openPoints(tetrahedron().vertices, 6);
  for (index_t i = 0; i < 4; ++i) {
    EXPECT_EQ(open.neighbors.count(i), 3u);
    EXPECT_EQ(open.neighbors.row(i)[3], NeighborRows::NONE);
  }
}

/** Settle the fans of added triangles at all vertices. */
Triangles
settled(PartialShape& partial, const Triangles& added, bool keep_given = true)
{
  for (const Triangle& t : added)
    partial.surface.add(t);
  std::vector<index_t> points(partial.shape.vertices.size());
  std::iota(points.begin(), points.end(), 0);
  settleFans(partial.surface, points, keep_given);
  return liveTriangles(partial.surface);
}

TEST(SettleFans, LeavesTheEarlierHalfOfABowTie)
{
  PartialShape partial({bowTie().vertices, {}});
  EXPECT_EQ(settled(partial, bowTie().triangles), (Triangles{bowTie().triangles[0]}));
}

TEST(SettleFans, LeavesTheFanWithTheMostTriangles)
{
  PartialShape partial({randomPositions(6, 1), {}});
  EXPECT_EQ(settled(partial, {{0, 1, 2}, {0, 3, 4}, {0, 4, 5}}),
            (Triangles{{0, 3, 4}, {0, 4, 5}}));
}

TEST(SettleFans, LeavesTheGivenFan)
{
  for (const bool keep_given : {true, false}) {
    PartialShape partial({randomPositions(6, 1), {{0, 1, 2}}});
    EXPECT_EQ(settled(partial, {{0, 3, 4}, {0, 4, 5}}, keep_given),
              (Triangles{{0, 1, 2}}));
  }
}

TEST(SettleFans, LooksAtThePointsOfRemovedTriangles)
{
  // removing the fan {3, 4} at 0 leaves two fans at 4
  PartialShape partial({randomPositions(12, 1), {{0, 1, 2}}});
  for (const Triangle& t : Triangles{{0, 3, 4}, {4, 3, 5}, {4, 0, 6}, {4, 6, 7}})
    partial.surface.add(t);
  settleFans(partial.surface, {0}, true);
  EXPECT_TRUE(isIcadm(liveTriangles(partial.surface), 12));
}

TEST(SettleFans, LeavesSingleFansAlone)
{
  const Shape sphere = icosphere(2);
  PartialShape partial({sphere.vertices, {}});
  EXPECT_EQ(settled(partial, sphere.triangles), sphere.triangles);
}

TEST(SettleFans, EndsWithOneFanEverywhereWhateverIsAdded)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const OpenSurface open = openPoints(randomPositions(14, seed), 6);
    RandomSource random(seed);
    Triangles added;
    std::vector<std::pair<index_t, index_t>> edges; // directed, each once
    while (added.size() < 10 && edges.size() < 500) {
      const Triangle t{static_cast<index_t>(random.below(14)),
                       static_cast<index_t>(random.below(14)),
                       static_cast<index_t>(random.below(14))};
      bool fits = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
      for (std::size_t i = 0; i < 3; ++i)
        fits = fits && std::find(edges.begin(),
                                 edges.end(),
                                 std::make_pair(t[i], t[(i + 1) % 3])) == edges.end();
      if (!fits)
        continue;
      added.push_back(t);
      for (std::size_t i = 0; i < 3; ++i)
        edges.emplace_back(t[i], t[(i + 1) % 3]);
    }
    PartialShape partial({open.positions, {}});
    ASSERT_TRUE(isIcadm(settled(partial, added), 14)) << seed;
  }
}

} // namespace
} // namespace pcl::ccaa::test
