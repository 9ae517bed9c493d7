// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of fans that go around what is in the way.

#include <gtest/gtest.h>

#include "filling/avoiding_fans.h"
#include "filling/disc_check.h"
#include "filling/minimum_weight_filling.h"
#include "filling_samples.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <vector>

namespace pcl::repair {
namespace {

using test::holeIn;

/** A segment that stands in a hole. */
struct Needle {
  Position foot;
  Position tip;
};

FillingTask
holeWith(std::size_t edges, std::vector<Needle> needles)
{
  FillingTask task = holeIn({edges});
  task.obstructed = [needles = std::move(needles)](const ccaa::Corners& corners) {
    return std::any_of(needles.begin(), needles.end(), [&](const Needle& needle) {
      return ccaa::segmentMeetsTriangle(needle.foot, needle.tip, corners);
    });
  };
  return task;
}

const Needle ASIDE{{0.2, 0.1, -5.0}, {0.2, 0.1, 0.3}};
const Needle HANGING{{-0.4, -0.1, -0.2}, {-0.4, -0.1, 5.0}};

void
expectWayAround(const FillingTask& task)
{
  EXPECT_FALSE(MinimumWeightFilling().close(task).closed());
  const Filling filling = AvoidingFans().close(task);
  ASSERT_TRUE(filling.closed());
  EXPECT_TRUE(isDisc(filling, task.polygon.size()));
  const Positions all = test::verticesOf(task, filling);
  for (const Triangle& triangle : filling.triangles)
    EXPECT_FALSE(task.obstructed(ccaa::cornersOf(triangle, all)));
  ccaa::RunControl control;
  EXPECT_TRUE(
      ccaa::findSelfIntersections(filling.triangles, all, 1, control).pairs.empty());
}

/** A flat polygon: whatever its triangulation, the needle pierces it. */
TEST(AvoidingFans, GoAroundWhatNoTriangulationOfTheBoundaryAvoids)
{
  for (const std::size_t edges : {5, 12, 40})
    expectWayAround(holeWith(edges, {ASIDE}));
}

TEST(AvoidingFans, GoAboveOneThingAndBelowAnother)
{
  expectWayAround(holeWith(24, {ASIDE, HANGING}));
}

TEST(AvoidingFans, AreAFlatFanWhereNothingIsInTheWay)
{
  const FillingTask task = holeWith(16, {});
  const Filling filling = AvoidingFans().close(task);
  ASSERT_EQ(1U, filling.inner.size());
  EXPECT_EQ(16U, filling.triangles.size());
  EXPECT_NEAR(0.0, filling.inner.front().z(), 1e-12);
}

TEST(AvoidingFans, SayWhenThereIsNoWay)
{
  FillingTask task = holeIn({8});
  std::size_t asked = 0;
  task.obstructed = [&asked](const ccaa::Corners&) {
    ++asked;
    return true;
  };
  const Filling filling = AvoidingFans().close(task);
  EXPECT_FALSE(filling.closed());
  EXPECT_TRUE(filling.triangles.empty());
  EXPECT_LT(asked, 20000U);
}

} // namespace
} // namespace pcl::repair
