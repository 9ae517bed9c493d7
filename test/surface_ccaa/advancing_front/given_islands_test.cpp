// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: islands: which to trust, how to turn them.
#include <gtest/gtest.h>

#include "advancing_front/doubtful_triangles.h"
#include "advancing_front/island_alignment.h"
#include "advancing_front/new_islands.h"
#include "mesh/islands.h"
#include "open_shapes.h"
#include "support/clouds.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::ccaa::test {
namespace {

Doubts
doubtsAbout(const Shape& shape)
{
  const TriangleAdjacency adjacency = adjacencyOf(shape);
  return doubtfulTriangles(
      shape.triangles, adjacency, labelIslands(adjacency), shape.vertices, {});
}

TEST(DoubtfulTriangles, AreNoneOnASmoothSurface)
{
  for (const Shape& shape : {icosphere(3), torus(48, 20), terrain(20, 20)})
    EXPECT_TRUE(doubtsAbout(shape).triangles.empty());
}

TEST(DoubtfulTriangles, AreThoseAroundASpike)
{
  Shape shape = icosphere(4);
  shape.vertices[700] *= 1.5;
  const Doubts doubts = doubtsAbout(shape);
  std::vector<index_t> at_spike;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    if (std::find(shape.triangles[t].begin(), shape.triangles[t].end(), 700) !=
        shape.triangles[t].end())
      at_spike.push_back(static_cast<index_t>(t));
  EXPECT_TRUE(std::includes(doubts.triangles.begin(),
                            doubts.triangles.end(),
                            at_spike.begin(),
                            at_spike.end()));
  EXPECT_LE(doubts.triangles.size(), 2 * at_spike.size()); // and what they fold against
}

TEST(DoubtfulTriangles, AreNotTheSharpEdgesOfAShapeThatHasMany)
{
  EXPECT_TRUE(doubtsAbout(cube(10)).triangles.empty()); // 240 of 1800 edges
}

/** A strip of triangles folded at random, as outliers make it. */
Shape
crumpled(std::uint64_t seed)
{
  Shape shape = grid(8, 8);
  RandomSource random(seed);
  for (Position& vertex : shape.vertices)
    vertex.z() = random.uniform(-2.0, 2.0);
  return translated(scaled(shape, 0.2), {5, 5, 5});
}

TEST(DoubtfulTriangles, AreAllOfACrumpledIsland)
{
  const Shape sphere = icosphere(4);
  const Doubts doubts = doubtsAbout(joined(sphere, crumpled(3)));
  ASSERT_EQ(doubts.triangles.size(), crumpled(3).triangles.size());
  EXPECT_EQ(doubts.triangles.front(), static_cast<index_t>(sphere.triangles.size()));
}

TEST(DoubtfulTriangles, AreNotThoseOfASmallSmoothIsland)
{
  EXPECT_TRUE(doubtsAbout(joined(icosphere(4), translated(icosphere(2), {3, 0, 0})))
                  .triangles.empty());
}

TEST(DoubtfulTriangles, KnowTheMedianFoldOfTheLargestIsland)
{
  EXPECT_NEAR(doubtsAbout(grid(10, 10)).typical_fold, 0.0, 1e-9);
  EXPECT_NEAR(doubtsAbout(joined(grid(20, 20), crumpled(3))).typical_fold, 0.0, 1e-9);
}

TEST(DoubtfulTriangles, OfNothingAreNone)
{
  EXPECT_TRUE(doubtsAbout({grid(2, 2).vertices, {}}).triangles.empty());
}

/** Pairs of boundary points of different parts closer than a reach. */
std::vector<PartContact>
contactsWithin(const Shape& shape, const Islands& parts, double reach)
{
  const PartialShape partial(shape);
  const auto at = [&](index_t vertex) {
    return PartPoint{vertex, parts[std::size_t(*partial.adjacency.begin(vertex))]};
  };
  std::vector<PartContact> contacts;
  for (const index_t one : partial.openVertices())
    for (const index_t other : partial.openVertices())
      if (partial.adjacency.fan(one) == Fan::OPEN &&
          partial.adjacency.fan(other) == Fan::OPEN && at(one).part != at(other).part &&
          (shape.vertices[std::size_t(one)] - shape.vertices[std::size_t(other)])
                  .norm() < reach)
        contacts.push_back({at(one), at(other)});
  return contacts;
}

bool
align(Shape& shape,
      double reach,
      const Positions& normals = {},
      const std::vector<index_t>& doubts = {})
{
  TriangleAdjacency adjacency = adjacencyOf(shape);
  OrientationHints hints;
  if (!normals.empty())
    hints.normals = normals;
  RunControl control;
  const std::vector<double> evidence =
      evidentSides(shape.triangles, adjacency, shape.vertices, hints, control);
  const Islands parts = labelIslands(adjacency, {}, doubts);
  const IslandVotes votes = askNeighbors(shape.triangles,
                                         adjacency,
                                         labelIslands(adjacency),
                                         parts,
                                         shape.vertices,
                                         contactsWithin(shape, parts, reach));
  return alignIslands(shape.triangles, adjacency, parts, votes, evidence);
}

/** A sphere cut into pieces by gaps one triangle wide. */
Shape
cutSphere()
{
  Shape sphere = icosphere(4);
  std::vector<std::size_t> cut;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    Position low = sphere.vertices[std::size_t(sphere.triangles[t][0])], high = low;
    for (const index_t corner : sphere.triangles[t]) {
      low = low.cwiseMin(sphere.vertices[std::size_t(corner)]);
      high = high.cwiseMax(sphere.vertices[std::size_t(corner)]);
    }
    for (int axis = 0; axis < 3; ++axis)
      if (low[axis] < 0.21 && high[axis] > 0.21) {
        cut.push_back(t);
        break;
      }
  }
  return withoutTriangles(sphere, cut);
}

TEST(AlignIslands, TurnsThePiecesOfASphereAlike)
{
  const Shape sphere = cutSphere();
  const std::vector<std::size_t> pieces = pieceOfTriangles(sphere.triangles);
  ASSERT_EQ(*std::max_element(pieces.begin(), pieces.end()), 7u);
  for (unsigned int turned = 0; turned < 256; turned += 17) {
    Shape shape = sphere;
    for (std::size_t t = 0; t < pieces.size(); ++t)
      if ((turned >> pieces[t] & 1u) != 0)
        std::swap(shape.triangles[t][0], shape.triangles[t][1]);
    align(shape, 0.3);
    EXPECT_TRUE(sameTriangles(sphere.triangles, shape.triangles) ||
                sameTriangles(reversed(sphere.triangles), shape.triangles))
        << turned;
  }
}

TEST(AlignIslands, LeavesPiecesAloneThatAgree)
{
  Shape shape = cutSphere();
  EXPECT_FALSE(align(shape, 0.3));
  EXPECT_EQ(shape.triangles, cutSphere().triangles);
}

TEST(AlignIslands, LeavesTheSheetsOfAThinPlateAlone)
{
  for (const bool facing_apart : {true, false}) {
    Shape plate = thinPlate(12, 12, 1.5);
    if (!facing_apart)
      plate = joined(grid(12, 12), translated(grid(12, 12), {0, 0, 1.5}));
    const Triangles before = plate.triangles;
    EXPECT_FALSE(align(plate, 1.6));
    EXPECT_EQ(plate.triangles, before);
  }
}

TEST(AlignIslands, FollowsNormals)
{
  const Shape sphere = cutSphere();
  Shape shape = sphere;
  shape.triangles = withEverySecondPieceReversed(shape.triangles);
  EXPECT_TRUE(align(shape, 0.3, sphere.vertices));
  EXPECT_TRUE(sameTriangles(sphere.triangles, shape.triangles));
}

TEST(AlignIslands, FollowsMostOfTheNormals)
{
  const Shape sphere = cutSphere();
  Positions normals = sphere.vertices;
  for (std::size_t v = 0; v < normals.size(); v += 3)
    normals[v] *= v % 2 == 0 ? -1.0 : std::nan("");
  Shape shape = sphere;
  shape.triangles = withEverySecondPieceReversed(shape.triangles);
  align(shape, 0.3, normals);
  EXPECT_TRUE(sameTriangles(sphere.triangles, shape.triangles));
}

/** Two pieces of a plane side by side, the second one looking down and known to. */
TEST(AlignIslands, TurnNoIslandAgainstEvidence)
{
  const Shape second = translated(grid(6, 6), {6.0, 0.0, 0.0});
  Shape shape = joined(grid(6, 6), {second.vertices, reversed(second.triangles)});
  const Triangles before = shape.triangles;
  Positions normals(72, Position::UnitZ());
  std::fill(normals.begin() + 36, normals.end(), Position(-Position::UnitZ()));
  EXPECT_FALSE(align(shape, 1.5, normals));
  EXPECT_EQ(shape.triangles, before);
}

TEST(AlignIslands, TurnOneWithoutEvidenceToOneWithIt)
{
  const Shape large = translated(grid(9, 9), {6.0, 0.0, 0.0});
  Shape shape = joined(grid(6, 6), {large.vertices, reversed(large.triangles)});
  Positions normals(shape.vertices.size(), Position::Zero());
  std::fill(normals.begin(), normals.begin() + 36, Position::UnitZ());
  EXPECT_TRUE(align(shape, 1.5, normals));
  EXPECT_TRUE(sameTriangles(joined(grid(6, 6), large).triangles, shape.triangles));
}

Triangles
largeOf(const Shape& shape, std::size_t rim, std::size_t minimum, double typical = 0.0)
{
  return largeComponents(shape.triangles, rim, shape.vertices, {minimum, typical});
}

TEST(LargeComponents, AreThoseConnectedToTheRim)
{
  const Shape floor = grid(4, 4); // 4 internal points
  const Triangles made(floor.triangles.begin() + 5, floor.triangles.end());
  EXPECT_EQ(largeOf(floor, 5, 100), made);
}

TEST(LargeComponents, AreThoseOfNewPiecesWithEnoughInternalPoints)
{
  const Shape both = joined(grid(4, 4), translated(grid(7, 7), {20, 0, 0}));
  const Triangles expected(both.triangles.begin() + 18, both.triangles.end());
  EXPECT_EQ(largeOf(both, 0, 4), both.triangles);
  EXPECT_EQ(largeOf(both, 0, 5), expected);
  EXPECT_EQ(largeOf(both, 0, 25), expected);
  EXPECT_TRUE(largeOf(both, 0, 26).empty());
}

TEST(LargeComponents, AreNotThoseOfCrumpledPieces)
{
  const Shape both = joined(grid(20, 20), crumpled(2));
  EXPECT_EQ(largeOf(both, 0, 1), grid(20, 20).triangles);
}

TEST(LargeComponents, AreCrumpledOnlyAgainstWhatIsTypical)
{
  const Shape piece = crumpled(2);
  EXPECT_TRUE(largeOf(piece, 0, 1, 0.05).empty());
  EXPECT_EQ(largeOf(piece, 0, 1, 2.5), piece.triangles);
}

TEST(LastingPieces, AreIslandsWithEnoughInternalPoints)
{
  const Shape both = joined(grid(4, 4), translated(grid(4, 4), {20, 0, 0}));
  const LastingPieces pieces = lastingPieces(adjacencyOf(both), 0, 4);
  EXPECT_EQ(pieces.flags, std::vector<std::uint8_t>(36, 1));
  EXPECT_EQ(pieces.count, 2u);
  EXPECT_EQ(lastingPieces(adjacencyOf(both), 0, 5).count, 0u);
}

TEST(LastingPieces, AreThoseOfTheFirstTriangles)
{
  const Shape both = joined(grid(4, 4), translated(grid(4, 4), {20, 0, 0}));
  std::vector<std::uint8_t> expected(36, 0);
  std::fill(expected.begin(), expected.begin() + 18, std::uint8_t(1));
  const LastingPieces pieces = lastingPieces(adjacencyOf(both), 1, 5);
  EXPECT_EQ(pieces.flags, expected);
  EXPECT_EQ(pieces.count, 1u);
}

/** Two pieces of a plane side by side, with two triangles between them. */
Shape
pairWithBridge(bool second_is_reversed)
{
  const Shape second = translated(grid(3, 3), {9.0, 3.0, 0.0});
  Shape shape =
      joined(grid(9, 9),
             {second.vertices,
              second_is_reversed ? reversed(second.triangles) : second.triangles});
  const index_t low = 3 * 9 + 8, high = low + 9, near = 81, far = near + 3;
  shape.triangles.push_back({low, near, high});
  shape.triangles.push_back({high, near, far});
  return shape;
}

TEST(AlignIslands, TurnAPartThatOnlyDoubtfulTrianglesConnect)
{
  const Shape alike = pairWithBridge(false);
  Shape shape = pairWithBridge(true);
  const auto last = static_cast<index_t>(shape.triangles.size()) - 1;
  ASSERT_EQ(labelIslands(adjacencyOf(shape)).count, 1u);
  EXPECT_TRUE(align(shape, 1.5, {}, {last - 1, last}));
  shape.triangles.resize(std::size_t(last) - 1);
  EXPECT_TRUE(sameTriangles(shape.triangles,
                            {alike.triangles.begin(), alike.triangles.end() - 2}));
}

TEST(AlignIslands, LeaveAPartAloneThatAgreesWithItsIsland)
{
  Shape shape = pairWithBridge(false);
  const auto last = static_cast<index_t>(shape.triangles.size()) - 1;
  EXPECT_FALSE(align(shape, 1.5, {}, {last - 1, last}));
}

} // namespace
} // namespace pcl::ccaa::test
