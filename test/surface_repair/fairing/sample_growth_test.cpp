// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of patches that grow over samples.
#include <gtest/gtest.h>

#include "fairing/sample_growth.h"
#include "fairing_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::repair::test {
namespace {

constexpr std::size_t EVERY = 15; /**< vertex that is lost is a sample */

bool
isFree(const ccaa::Corners&)
{
  return false;
}

/** The upper half of a drawn out sphere is lost, but for samples. */
PatchedHole
lostLimb()
{
  PatchedHole hole = withStrip(ccaa::test::ellipsoid(4, 4.0),
                               [](const Position& p) { return p.z() > 1.0; });
  for (std::size_t i = 0; i < hole.lost.size(); i += EVERY)
    hole.model.free_points.push_back(hole.lost[i]);
  std::sort(hole.model.free_points.begin(),
            hole.model.free_points.end(),
            [](const Position& a, const Position& b) { return a.z() < b.z(); });
  return hole;
}

std::vector<std::size_t>
allSamples(const PatchedHole& hole)
{
  std::vector<std::size_t> samples(hole.model.free_points.size());
  std::iota(samples.begin(), samples.end(), std::size_t(0));
  return samples;
}

/** Between the patch and the plane z = 1. */
double
volumeOver(const Patch& patch)
{
  double volume = 0.0;
  for (const Triangle& triangle : patch.triangles) {
    ccaa::Corners corners = ccaa::cornersOf(triangle, patch.positions);
    for (Position& corner : corners)
      corner.z() -= 1.0;
    volume += corners[0].dot(corners[1].cross(corners[2])) / 6.0;
  }
  return std::abs(volume);
}

TEST(GrowOver, MakesEverySampleAVertexOfOneDisc)
{
  PatchedHole hole = lostLimb();
  growOver(hole.model, allSamples(hole), isFree, hole.patch);
  EXPECT_TRUE(isSound(hole));
  EXPECT_EQ(1, eulerCharacteristic(hole.patch));
  std::vector<std::size_t> used;
  for (std::size_t v = 0; v < hole.patch.positions.size(); ++v)
    if (hole.patch.free_point[v] != NONE) {
      used.push_back(hole.patch.free_point[v]);
      EXPECT_EQ(hole.model.free_points[used.back()], hole.patch.positions[v]);
    }
  std::sort(used.begin(), used.end());
  EXPECT_EQ(allSamples(hole), used);
}

/** A half of an ellipsoid over z = 1: pi b (2 - 3 s + s^3) / 3 with s = 1 / 4, b = 4.
 */
TEST(GrowOver, EnclosesTheLimbThatTheSamplesDescribe)
{
  PatchedHole hole = lostLimb();
  growOver(hole.model, allSamples(hole), isFree, hole.patch);
  const double whole = std::acos(-1.0) * 4.0 * (2.0 - 0.75 + 0.25 * 0.25 * 0.25) / 3.0;
  EXPECT_GT(volumeOver(hole.patch), 0.85 * whole);
  EXPECT_LT(volumeOver(hole.patch), 1.02 * whole);
}

TEST(GrowOver, LeavesOutWhatHasNoRoom)
{
  PatchedHole hole = lostLimb();
  const Patch before = hole.patch;
  const auto beyond_two = [](const ccaa::Corners& corners) {
    return std::any_of(corners.begin(), corners.end(), [](const Position& corner) {
      return corner.z() > 2.0;
    });
  };
  growOver(hole.model, allSamples(hole), beyond_two, hole.patch);
  EXPECT_TRUE(isSound(hole));
  EXPECT_GT(hole.patch.positions.size(), before.positions.size());
  for (const Position& position : hole.patch.positions)
    EXPECT_LE(position.z(), 2.0);
}

TEST(GrowOver, LeavesThePatchAloneWithoutSamples)
{
  PatchedHole hole = lostLimb();
  const Patch before = hole.patch;
  growOver(hole.model, {}, isFree, hole.patch);
  EXPECT_EQ(before.triangles, hole.patch.triangles);
}

} // namespace
} // namespace pcl::repair::test
