// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closing what is open between frozen triangles.
#include <gtest/gtest.h>

#include "mesh/intersection.h"
#include "support/completion_shapes.h"
#include "support/edge_sets.h"
#include "support/mesh_asserts.h"
#include "support/mesh_topology.h"
#include "support/random_source.h"
#include "tiles/facing.h"
#include "tiles/seam.h"
#include "tiles/seam_settlement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace pcl::ccaa::test {
namespace {

constexpr float ENDLESS = std::numeric_limits<float>::max();

/** The triangles of a shape without those with a corner in some places, whose points
 * are disputes; all is near. */
Seam
withGap(const Shape& shape, const std::function<bool(const Position&)>& is_disputed)
{
  Seam seam;
  for (const Position& position : shape.vertices)
    seam.points.push_back(position.cast<float>());
  seam.is_open.assign(seam.points.size(), 0);
  seam.is_near.assign(seam.points.size(), 1);
  seam.is_whole = seam.is_near;
  seam.room.assign(seam.points.size(), ENDLESS);
  for (const Triangle& triangle : shape.triangles) {
    if (std::none_of(triangle.begin(), triangle.end(), [&](index_t i) {
          return is_disputed(shape.vertices[std::size_t(i)]);
        })) {
      seam.given.push_back(triangle);
      continue;
    }
    for (const index_t corner : triangle)
      seam.is_open[std::size_t(corner)] = 1;
  }
  return seam;
}

SeamFilling
close(const Seam& seam, int threads = 1)
{
  return closeSeam(seam, CompletionParameters(), threads, {});
}

/** Given triangles that stay, and those that were added. */
Triangles
closed(const Seam& seam, const SeamFilling& filling)
{
  EXPECT_EQ(filling.error, "");
  EXPECT_TRUE(std::is_sorted(filling.removed.begin(), filling.removed.end()));
  Triangles all;
  for (std::size_t t = 0; t < seam.given.size(); ++t)
    if (!std::binary_search(filling.removed.begin(), filling.removed.end(), index_t(t)))
      all.push_back(seam.given[t]);
  all.insert(all.end(), filling.added.begin(), filling.added.end());
  EXPECT_TRUE(isIcadm(all, seam.points.size()));
  return all;
}

bool
isInBelt(const Position& position)
{
  return std::abs(position.z()) < 0.12;
}

TEST(Seam, ABeltBetweenTwoFrozenCapsIsClosed)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Seam seam = withGap(noisyIcosphere(4, 0.003, seed), isInBelt);
    seam.given = randomlyReversed(seam.given, seed);
    const SeamFilling filling = close(seam);
    EXPECT_TRUE(filling.removed.empty());
    const Triangles all = closed(seam, filling);
    EXPECT_EQ(countBoundaryEdges(all), 0U) << seed;
    EXPECT_EQ(topologyOf(all).characteristic, 2);
    EXPECT_EQ(all.size(), 5120U);
  }
}

TEST(Seam, PiecesThatAreWoundAgainstEachOtherAreJoined)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Seam seam = withGap(noisyIcosphere(4, 0.003, seed), isInBelt);
    for (Triangle& triangle : seam.given)
      if (seam.points[std::size_t(triangle[0])].z() < 0.0F)
        std::swap(triangle[0], triangle[1]);
    EXPECT_EQ(countBoundaryEdges(closed(seam, close(seam))), 0U) << seed;
  }
}

TEST(Seam, IsTheSameForAnyNumberOfThreads)
{
  const Seam seam = withGap(noisyIcosphere(4, 0.005, 4), isInBelt);
  const SeamFilling one = close(seam, 1), three = close(seam, 3);
  EXPECT_EQ(one.added, three.added);
  EXPECT_EQ(one.removed, three.removed);
}

TEST(Seam, NothingReachesOutOfItsRoom)
{
  const auto isInside = [](const Seam& seam, const Triangle& triangle, float room) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto place = [&](std::size_t corner) {
        return seam.points[std::size_t(triangle[corner % 3])];
      };
      if ((place(i + 1) - place(i)).norm() <= room &&
          (place(i + 2) - place(i)).norm() <= room)
        return true;
    }
    return false;
  };
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const float room : {ENDLESS, 0.08F, 0.06F, 0.0F}) {
    Seam seam = withGap(noisyIcosphere(4, 0.003, 1), isInBelt);
    seam.room.assign(seam.points.size(), room);
    const SeamFilling filling = close(seam);
    EXPECT_TRUE(isSubsetOf(seam.given, closed(seam, filling)));
    for (const Triangle& triangle : filling.added)
      EXPECT_TRUE(isInside(seam, triangle, room));
    EXPECT_LT(filling.added.size(), least);
    least = filling.added.size();
  }
  EXPECT_EQ(least, 0U);
}

TEST(Seam, NothingGrowsFromTheRimOfWhatIsKnown)
{
  const Shape ground = terrain(40, 40, 1.0);
  const Seam seam = withGap(ground, [](const Position& p) {
    return std::abs(p.x() - 19.0) < 2.0 && p.y() > 6.0;
  });
  const Triangles all = closed(seam, close(seam));
  EXPECT_TRUE(isSubsetOf(seam.given, all));
  const auto uses = trianglesOfEdges(all), before = trianglesOfEdges(seam.given);
  for (const auto& [edge, triangles] : before) {
    if (seam.is_open[std::size_t(edge.first)] == 0 ||
        seam.is_open[std::size_t(edge.second)] == 0) {
      EXPECT_EQ(triangles.size(), uses.at(edge).size());
    }
  }
}

TEST(Seam, FansInSeveralPiecesKeepTheLargest)
{
  // Every second triangle around a vertex is missing.
  Shape sphere = icosphere(4);
  const index_t apex = 20;
  Seam seam;
  for (const Position& position : sphere.vertices)
    seam.points.push_back(position.cast<float>());
  seam.is_open.assign(seam.points.size(), 0);
  seam.is_near.assign(seam.points.size(), 1);
  seam.is_whole = seam.is_near;
  seam.room.assign(seam.points.size(), ENDLESS);
  int number = 0;
  for (const Triangle& triangle : sphere.triangles) {
    if (std::count(triangle.begin(), triangle.end(), apex) > 0 && ++number % 2 == 0)
      for (const index_t corner : triangle)
        seam.is_open[std::size_t(corner)] = 1;
    else
      seam.given.push_back(triangle);
  }
  const SeamFilling filling = close(seam);
  EXPECT_FALSE(filling.removed.empty());
  for (const index_t t : filling.removed)
    EXPECT_TRUE(
        std::any_of(seam.given[std::size_t(t)].begin(),
                    seam.given[std::size_t(t)].end(),
                    [&](index_t i) { return seam.is_open[std::size_t(i)] != 0; }));
  EXPECT_TRUE(sameUnorientedTriangles(sphere.triangles, closed(seam, filling)));
}

/** Seven triangles around a point, of which (0, 1, 2) is to be made anew and (0, 4, 5)
 * cannot be wound like the others. \param[in] rim points of which some are missing */
SettledSeam
settledWheel(const std::vector<std::size_t>& rim)
{
  Seam seam;
  seam.points.emplace_back(0.0F, 0.0F, 0.0F);
  for (index_t i = 1; i <= 7; ++i) {
    const double angle = i * 2.0 * M_PI / 7.0;
    seam.points.emplace_back(float(std::cos(angle)), float(std::sin(angle)), 0.0F);
    seam.given.push_back({0, i, i % 7 + 1});
  }
  seam.is_open.assign(8, 0);
  seam.is_near = seam.is_whole = std::vector<std::uint8_t>(8, 1);
  for (const std::size_t v : rim)
    seam.is_whole[v] = 0;
  seam.room.assign(8, ENDLESS);
  return settleSeam(seam, {1, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0, 0}, 1);
}

TEST(Seam, TheSmallerOfTwoFansThatARemovalLeavesGoesAsWell)
{
  EXPECT_EQ(settledWheel({}).removed, (std::vector<index_t>{0, 1, 2, 3}));
}

TEST(Seam, NothingGoesWhereTheSmallerFanHasToStay)
{
  EXPECT_TRUE(settledWheel({3, 6}).removed.empty());
}

TEST(Seam, RandomDamageIsMendedWithoutLosingWhatIsNotTold)
{
  std::size_t open = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomSource random(seed);
    const Shape sphere = noisyIcosphere(4, 0.004, seed);
    std::set<index_t> disputed;
    for (int i = 0; i < 12; ++i)
      disputed.insert(index_t(random.below(sphere.vertices.size())));
    Seam seam = withGap(sphere, [](const Position&) { return false; });
    Triangles given;
    for (const Triangle& triangle : sphere.triangles) {
      const bool touches = std::any_of(triangle.begin(),
                                       triangle.end(),
                                       [&](index_t i) { return disputed.count(i); });
      if (!touches || random.below(2) == 0)
        given.push_back(triangle);
      else
        for (const index_t corner : triangle)
          seam.is_open[std::size_t(corner)] = 1;
    }
    seam.given = given;
    open += countBoundaryEdges(closed(seam, close(seam)));
  }
  EXPECT_EQ(open, 0U);
}

/** A Moebius band beside a sphere that lacks its belt. */
Seam
besideABand()
{
  const Shape sphere = noisyIcosphere(4, 0.003, 1);
  const Shape band = translated(moebiusBand(60), {5.0, 0.0, 0.0});
  return withGap(joined(sphere, band), [](const Position& position) {
    return position.x() < 2.0 && isInBelt(position);
  });
}

TEST(Seam, ABeltIsClosedBesideAOneSidedPiece)
{
  const Seam seam = besideABand();
  const SeamFilling filling = close(seam);
  EXPECT_TRUE(filling.removed.empty());
  EXPECT_EQ(countBoundaryEdges(closed(seam, filling)), 120U); // those of the band
}

TEST(Seam, AGapInAOneSidedPieceLeavesOneFanAtEachPoint)
{
  Seam seam = besideABand();
  const auto first =
      static_cast<std::size_t>(noisyIcosphere(4, 0.003, 1).vertices.size());
  for (std::size_t v = first + 20; v < first + 26; ++v)
    seam.is_open[v] = 1;
  closed(seam, close(seam));
}

TEST(Seam, PiecesLieAsTheirTileHasMadeThem)
{
  Seam seam = withGap(noisyIcosphere(4, 0.003, 1), isInBelt);
  const Triangles made = seam.given;
  seam.tile_of.assign(seam.given.size(), 3);
  // That of a piece would be that of its first triangle, which another tile has turned.
  std::swap(seam.given[0][1], seam.given[0][2]);
  TriangleAdjacency adjacency;
  adjacency.build(seam.given, seam.points.size());
  RunControl control;
  Winding pieces;
  ASSERT_TRUE(pieces.find(seam.given, adjacency, 1, control));
  ASSERT_EQ(pieces.components().size(), 2U);
  Triangles given = seam.given;
  for (std::size_t t = 0; t < given.size(); ++t)
    if (pieces.isTurned(t))
      std::swap(given[t][1], given[t][2]);
  turnAsMade(seam, pieces, given);
  EXPECT_TRUE(sameTriangles(made, given) || sameTriangles(reversed(made), given));
}

TEST(Seam, AFewPointsAreNoSeam)
{
  for (std::size_t count = 0; count < 4; ++count) {
    Seam seam;
    seam.points.assign(count, Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < count; ++i)
      seam.points[i][Eigen::Index(i) % 3] = 1.0F;
    seam.is_open.assign(count, 1);
    seam.is_near.assign(count, 1);
    seam.is_whole = seam.is_near;
    seam.room.assign(count, ENDLESS);
    EXPECT_TRUE(close(seam).removed.empty());
  }
}

/** Two triangles that have one corner in common stand in the gap; not all of that
 * corner is given, so that the base algorithm is shown one of them only. */
TEST(Seam, NothingCrossesATriangleThatTheBaseAlgorithmIsNotShown)
{
  Seam seam = withGap(noisyIcosphere(4, 0.003, 1), isInBelt);
  const auto first = static_cast<index_t>(seam.points.size());
  for (const Eigen::Vector3f& point : {Eigen::Vector3f(0.9F, 0.0F, 0.0F),
                                       Eigen::Vector3f(1.1F, 0.1F, 0.02F),
                                       Eigen::Vector3f(1.1F, 0.2F, 0.0F),
                                       Eigen::Vector3f(1.1F, -0.1F, 0.02F),
                                       Eigen::Vector3f(1.1F, -0.2F, 0.0F)}) {
    seam.points.push_back(point);
    seam.is_open.push_back(0);
    seam.is_near.push_back(0);
    seam.is_whole.push_back(0);
    seam.room.push_back(ENDLESS);
  }
  const std::size_t standing = seam.given.size();
  seam.given.push_back({first, first + 1, first + 2});
  seam.given.push_back({first, first + 3, first + 4});
  const SeamFilling filling = close(seam);
  EXPECT_GT(filling.added.size(), 500U);
  for (const Triangle& triangle : filling.added)
    for (std::size_t t = standing; t < seam.given.size(); ++t)
      EXPECT_FALSE(trianglesMeet(cornersOf(triangle, PointView(seam.points)),
                                 cornersOf(seam.given[t], PointView(seam.points))));
}

} // namespace
} // namespace pcl::ccaa::test
