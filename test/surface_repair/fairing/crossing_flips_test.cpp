// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of flips where a patch runs through itself.
#include <gtest/gtest.h>

#include "fairing/crossing_flips.h"
#include "fairing/patch_edges.h"
#include "fairing_samples.h"
#include "mesh/intersection.h"
#include "support/random_source.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::repair::test {
namespace {

/** Steps along a strip. */
constexpr int STEPS = 24;

bool
hitsNothing(const ccaa::Corners&)
{
  return false;
}

/** The two sides of a winding strip around an axis, as a rim. */
Positions
winding()
{
  Positions rim;
  const auto add = [&](double radius, int step) {
    const double angle = 4.0 * std::acos(-1.0) * step / STEPS;
    rim.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle);
  };
  for (int i = 0; i <= STEPS; ++i)
    add(2.0, i);
  for (int i = STEPS; i >= 0; --i)
    add(1.0, i);
  return rim;
}

/** The sides of a flat strip: points in line, of which triangles have no area. */
Positions
rectangle()
{
  Positions rim;
  for (int i = 0; i <= STEPS; ++i)
    rim.emplace_back(i, 0.0, 0.0);
  for (int i = STEPS; i >= 0; --i)
    rim.emplace_back(i, 1.0, 0.0);
  return rim;
}

/** A rim alone as a model, closed by a ladder from side to side. */
PatchedHole
filledStrip(const Positions& rim)
{
  PatchedHole hole;
  hole.model.positions = hole.patch.positions = rim;
  const auto count = static_cast<pcl::index_t>(hole.patch.positions.size());
  for (pcl::index_t v = 0; v < count; ++v)
    hole.patch.rim.push_back(v);
  Triangles& triangles = hole.patch.triangles;
  for (pcl::index_t v = 0; v < STEPS; ++v) {
    triangles.push_back({v, v + 1, count - 1 - v});
    triangles.push_back({v + 1, count - 2 - v, count - 1 - v});
  }
  hole.model.adjacency.build({}, hole.model.positions.size());
  hole.patch.hole.assign(triangles.size(), 0);
  hole.patch.free_point.assign(hole.patch.positions.size(), NONE);
  return hole;
}

/** The same after flips at random. */
PatchedHole
foldedStrip(std::uint64_t seed, const Positions& rim = winding())
{
  PatchedHole hole = filledStrip(rim);
  ccaa::test::RandomSource random(seed);
  PatchEdges edges(hole.model, hole.patch);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t side = random.below(edges.count());
    if (!edges.isInner(side))
      continue;
    const auto ends = edges.pairAt(side);
    if (!edges.areJoined(ends.c, ends.d))
      edges.flip(side);
  }
  return hole;
}

std::vector<std::size_t>
crossingTriangles(const Patch& patch)
{
  const auto corners = [&](std::size_t t) {
    return ccaa::cornersOf(patch.triangles[t], patch.positions);
  };
  std::vector<std::size_t> crossing;
  for (std::size_t a = 0; a < patch.triangles.size(); ++a)
    for (std::size_t b = 0; b < patch.triangles.size(); ++b)
      if (a != b && ccaa::trianglesMeet(corners(a), corners(b))) {
        crossing.push_back(a);
        break;
      }
  return crossing;
}

void
flip(PatchedHole& hole)
{
  flipCrossings(hole.model, crossingTriangles(hole.patch), hitsNothing, hole.patch);
}

TEST(FlipCrossings, LeaveFewTrianglesThatMeet)
{
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PatchedHole hole = foldedStrip(seed);
    before += crossingTriangles(hole.patch).size();
    flip(hole);
    after += crossingTriangles(hole.patch).size();
  }
  EXPECT_LT(5 * after, before);
}

/** Of which each flip leaves fewer pairs of triangles that meet, or less bending. */
TEST(FlipCrossings, EndOnceNothingGetsBetter)
{
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    PatchedHole hole = foldedStrip(seed, rectangle());
    std::vector<std::size_t> all(hole.patch.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    ccaa::RunControl control(nullptr, 10000000);
    flipCrossings(hole.model, all, hitsNothing, hole.patch, &control);
    EXPECT_FALSE(control.cancelled()) << seed;
  }
}

TEST(FlipCrossings, KeepTheDiscAndItsRim)
{
  PatchedHole hole = foldedStrip(1);
  flip(hole);
  EXPECT_EQ(winding(), hole.patch.positions);
  EXPECT_EQ(1U, surfaceKindOf(hole.patch).boundary_loops);
  EXPECT_EQ(1, surfaceKindOf(hole.patch).euler_characteristic);
  EXPECT_TRUE(surfaceKindOf(hole.patch).is_manifold);
  EXPECT_TRUE(surfaceKindOf(hole.patch).is_wound_alike);
}

TEST(FlipCrossings, LeaveAFreePatchAlone)
{
  PatchedHole hole = filledStrip(winding());
  const Triangles before = hole.patch.triangles;
  ASSERT_TRUE(crossingTriangles(hole.patch).empty());
  std::vector<std::size_t> all;
  for (std::size_t t = 0; t < before.size(); ++t)
    all.push_back(t);
  flipCrossings(hole.model, all, hitsNothing, hole.patch);
  EXPECT_EQ(before, hole.patch.triangles);
}

} // namespace
} // namespace pcl::repair::test
