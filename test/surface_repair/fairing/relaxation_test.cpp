// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the relaxation of patches.
#include <pcl/surface_repair/fairing/refinement.h>
#include <pcl/surface_repair/fairing/relaxation.h>

#include <gtest/gtest.h>

#include "fairing_samples.h"

#include <cmath>

namespace pcl {
namespace repair {
namespace test {
namespace {

double
offSphere(const Position& position)
{
  return std::abs(position.norm() - 1.0);
}

PatchedHole
refined(PatchedHole hole)
{
  refinePatch(hole.model, {}, hole.patch);
  return hole;
}

TEST(RelaxPatch, LeavesThePlaneAPlane)
{
  PatchedHole hole = refined(holedPlane(12, 8.0));
  EXPECT_TRUE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
  EXPECT_LT(largestOf(hole.patch, [](const Position& p) { return std::abs(p.z()); }),
            1e-9 * 16.0);
}

TEST(RelaxPatch, FindsTheCapOfASphere)
{
  for (const double angle : {0.3, 0.7, 1.2}) {
    PatchedHole hole = refined(cappedSphere(4, angle));
    EXPECT_TRUE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
    EXPECT_LT(largestOf(hole.patch, offSphere), 0.01 * angle * angle) << angle;
  }
}

TEST(RelaxPatch, MovesNoHeldVertex)
{
  PatchedHole hole = refined(cappedSphere(4, 0.7));
  const std::size_t held = hole.patch.positions.size() - 5;
  hole.patch.free_point[held] = 0;
  const Positions before = hole.patch.positions;
  relaxPatch(hole.model, {}, {}, hole.patch);
  for (std::size_t v = 0; v < hole.patch.rim.size(); ++v)
    EXPECT_EQ(hole.patch.positions[v], before[v]);
  EXPECT_EQ(hole.patch.positions[held], before[held]);
}

TEST(RelaxPatch, LeavesAPatchOfHeldVerticesAlone)
{
  PatchedHole hole = withStrip(ccaa::test::icosphere(3),
                               [](const Position& p) { return p.z() > 0.85; });
  const Positions before = hole.patch.positions;
  EXPECT_FALSE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
  EXPECT_EQ(hole.patch.positions, before);
}

} // namespace
} // namespace test
} // namespace repair
} // namespace pcl
