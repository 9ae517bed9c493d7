// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the refinement of patches.
#include <pcl/surface_repair/fairing/refinement.h>

#include <gtest/gtest.h>

#include "fairing_samples.h"

#include <cmath>

namespace pcl {
namespace repair {
namespace test {
namespace {

double
meanEdge(const Patch& patch)
{
  double sum = 0.0;
  for (const Triangle& triangle : patch.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      sum += (patch.positions[static_cast<std::size_t>(triangle[c])] -
              patch.positions[static_cast<std::size_t>(triangle[(c + 1) % 3])])
                 .norm();
  return sum / (3.0 * static_cast<double>(patch.triangles.size()));
}

TEST(RefinePatch, LeavesASoundDisc)
{
  for (const double angle : {0.2, 0.7, 1.5}) {
    PatchedHole hole = cappedSphere(4, angle);
    refinePatch(hole.model, {}, hole.patch);
    EXPECT_TRUE(isSound(hole)) << angle;
    EXPECT_EQ(eulerCharacteristic(hole.patch), 1) << angle;
  }
}

TEST(RefinePatch, KeepsWhatWasThere)
{
  PatchedHole hole = cappedSphere(4, 0.7);
  const Patch before = hole.patch;
  refinePatch(hole.model, {}, hole.patch);
  ASSERT_GT(hole.patch.positions.size(), before.positions.size());
  EXPECT_EQ(hole.patch.rim, before.rim);
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    EXPECT_EQ(hole.patch.positions[v], before.positions[v]);
  EXPECT_EQ(hole.patch.free_point.size(), hole.patch.positions.size());
  EXPECT_EQ(hole.patch.hole.size(), hole.patch.triangles.size());
}

TEST(RefinePatch, MakesEdgesAsLongAsThoseAround)
{
  PatchedHole hole = holedPlane(20, 14.0);
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_NEAR(meanEdge(hole.patch), 1.1, 0.15);
}

TEST(RefinePatch, TakesALengthOnRequest)
{
  PatchedHole hole = holedPlane(20, 14.0);
  RefinementParameters parameters;
  parameters.edge_length = 2.0;
  refinePatch(hole.model, parameters, hole.patch);
  EXPECT_NEAR(meanEdge(hole.patch), 2.1, 0.4);
}

TEST(RefinePatch, EndsAtTheGreatestNumber)
{
  PatchedHole hole = cappedSphere(4, 1.2);
  const std::size_t before = hole.patch.positions.size();
  RefinementParameters parameters;
  parameters.greatest_number = 37;
  refinePatch(hole.model, parameters, hole.patch);
  EXPECT_EQ(hole.patch.positions.size(), before + 37);
  EXPECT_TRUE(isSound(hole));
}

TEST(RefinePatch, StaysInThePlane)
{
  PatchedHole hole = holedPlane(12, 8.0);
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_EQ(largestOf(hole.patch, [](const Position& p) { return std::abs(p.z()); }),
            0.0);
}

} // namespace
} // namespace test
} // namespace repair
} // namespace pcl
