// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of where force lines begin.

#include <gtest/gtest.h>

#include "sphere_rims.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using test::Islands;
using test::sphereRim;

Islands
twoCaps()
{
  return Islands({sphereRim(0.35, true, 60), sphereRim(-0.35, false, 60)});
}

std::vector<PossibleOrigin>
originsOf(const Islands& islands, const Reach& reach = {})
{
  return originsBetweenIslands(
      islands.field, islands.targets, reach, ccaa::LoopContext());
}

TEST(LineOrigins, EverySourceThatAnotherIslandReachesIsOne)
{
  const Islands caps = twoCaps();
  EXPECT_EQ(caps.sources.size(), originsOf(caps).size());
}

TEST(LineOrigins, OneIslandAloneHasNone)
{
  EXPECT_TRUE(originsOf(Islands({sphereRim(0.35, true, 60)})).empty());
}

TEST(LineOrigins, GapIsTheDistanceToTheOtherIsland)
{
  for (const PossibleOrigin& origin : originsOf(twoCaps()))
    EXPECT_NEAR(0.7, origin.gap, 0.01);
}

TEST(LineOrigins, ReachFollowsTheGap)
{
  for (const PossibleOrigin& origin : originsOf(twoCaps()))
    EXPECT_DOUBLE_EQ(2.5 * origin.gap, origin.origin.query.falloff.far);
}

TEST(LineOrigins, GivenReachIsTaken)
{
  Reach reach;
  reach.far = 1.2;
  for (const PossibleOrigin& origin : originsOf(twoCaps(), reach))
    EXPECT_EQ(1.2, origin.origin.query.falloff.far);
}

TEST(LineOrigins, ForceAtTheRimOfACapPointsIntoTheGap)
{
  for (const PossibleOrigin& origin : originsOf(twoCaps()))
    EXPECT_GT(origin.force.outward, 0.0);
}

TEST(LineOrigins, NormalIsOnTheIslandsSideAndAcrossTheBoundary)
{
  for (const PossibleOrigin& origin : originsOf(twoCaps())) {
    EXPECT_GT(origin.force.normal.dot(origin.origin.normal), 0.0);
    EXPECT_NEAR(0.0, origin.force.normal.dot(origin.origin.tangent), 1e-12);
  }
}

TEST(LineOrigins, ChosenOnesKeepTheirDistanceAlongTheBoundary)
{
  const Islands caps = twoCaps();
  const std::vector<PossibleOrigin> origins = originsOf(caps);
  const std::vector<std::size_t> chosen = strongestOrigins(origins, caps.targets, 0.5);
  ASSERT_GT(chosen.size(), 8U);
  for (const std::size_t a : chosen)
    for (const std::size_t b : chosen) {
      const BoundaryPoint& first = origins[a].origin.point;
      const BoundaryPoint& second = origins[b].origin.point;
      if (a == b || first.curve != second.curve)
        continue;
      EXPECT_GT(caps.targets.arcBetween(
                    first.curve, caps.targets.arcAt(first), caps.targets.arcAt(second)),
                0.5 * 0.69);
    }
}

TEST(LineOrigins, RepelledOnesAreNotChosen)
{
  const Islands caps(
      {sphereRim(0.35, true, 60), test::turned(sphereRim(-0.35, false, 60))});
  EXPECT_TRUE(strongestOrigins(originsOf(caps), caps.targets, 0.5).empty());
}

TEST(LineOrigins, NarrowerGapComesFirst)
{
  std::vector<BoundaryCurve> curves = {sphereRim(0.35, true, 60),
                                       sphereRim(-0.35, false, 60)};
  for (Position& point : curves[1].points)
    point.z() += 0.25 * point.x();
  const Islands caps(curves);
  const std::vector<PossibleOrigin> origins = originsOf(caps);
  const std::vector<std::size_t> chosen = strongestOrigins(origins, caps.targets, 0.5);
  ASSERT_FALSE(chosen.empty());
  EXPECT_GT(origins[chosen.front()].origin.point.position.x(), 0.5);
}

} // namespace
} // namespace pcl::repair
