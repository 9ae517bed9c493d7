// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of choosing bridges among force lines.

#include <gtest/gtest.h>

#include "bridge/bridge.h"
#include "surface_repair/force_line/sphere_rims.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using test::Islands;
using test::sphereRim;

Islands
twoCaps()
{
  return Islands({sphereRim(0.35, true, 60, 0.3), sphereRim(-0.35, false, 67)});
}

std::vector<ForceLine>
linesOf(const Islands& islands)
{
  std::vector<ForceLine> lines;
  const ForceLineTracker tracker(islands.field, islands.targets, {});
  for (const std::size_t from : {0, 1})
    for (const LineOrigin& origin : islands.originsOn(from))
      lines.push_back(tracker.track(origin));
  return lines;
}

TEST(BridgeSelection, SupportingPointsOfABoundaryKeepTheirDistance)
{
  const Islands caps = twoCaps();
  std::vector<BoundaryPoint> supports;
  for (const Bridge& bridge : selectBridges(linesOf(caps), caps.targets, {0.0, 0.4})) {
    supports.push_back(bridge.begin);
    supports.push_back(bridge.end);
  }
  ASSERT_GT(supports.size(), 12U);
  for (std::size_t i = 0; i < supports.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (supports[i].curve == supports[j].curve) {
        EXPECT_GE(caps.targets.arcBetween(supports[i].curve,
                                          caps.targets.arcAt(supports[i]),
                                          caps.targets.arcAt(supports[j])),
                  0.4);
      }
}

TEST(BridgeSelection, OfEquallyLongLinesTheOneOfHigherQualityComesFirst)
{
  const Islands caps = twoCaps();
  std::vector<ForceLine> lines = linesOf(caps);
  for (ForceLine& line : lines)
    line.length = 0.7;
  lines[20].quality = 100.0;
  EXPECT_EQ(100.0, selectBridges(lines, caps.targets, {0.0, 0.4}).front().quality);
}

TEST(BridgeSelection, ShorterLineComesFirst)
{
  const Islands caps = twoCaps();
  std::vector<ForceLine> lines = linesOf(caps);
  lines[20].length = 0.1;
  EXPECT_EQ(lines[20].quality,
            selectBridges(lines, caps.targets, {0.0, 0.4}).front().quality);
}

TEST(BridgeSelection, LineThatDidNotArriveIsNoBridge)
{
  const Islands caps = twoCaps();
  std::vector<ForceLine> lines = linesOf(caps);
  for (ForceLine& line : lines)
    line.end = LineEnd::CROSSES_SURFACE;
  EXPECT_TRUE(selectBridges(lines, caps.targets, {0.0, 0.4}).empty());
}

TEST(BridgeSelection, LongerLinesNeedMoreRoom)
{
  const Islands caps = twoCaps();
  const std::vector<ForceLine> lines = linesOf(caps);
  EXPECT_LT(selectBridges(lines, caps.targets, {1.5, 0.1}).size(),
            selectBridges(lines, caps.targets, {0.5, 0.1}).size());
}

TEST(BridgeSelection, RoomIsUsedUp)
{
  const Islands caps = twoCaps();
  const std::size_t chosen =
      selectBridges(linesOf(caps), caps.targets, {0.0, 0.4}).size();
  // Between gaps of twice the distance another one would have fitted.
  EXPECT_GE(static_cast<double>(chosen), caps.targets.lengthOf(0) / (2.0 * 0.4 + 0.2));
}

TEST(BridgeSelection, BridgesEndAtVertices)
{
  const Islands caps = twoCaps();
  for (const Bridge& bridge : selectBridges(linesOf(caps), caps.targets, {0.0, 0.4}))
    for (const BoundaryPoint* end : {&bridge.begin, &bridge.end}) {
      EXPECT_EQ(0.0, end->share);
      EXPECT_EQ(caps.targets.curves()[end->curve].curve.points[end->edge],
                end->position);
    }
}

TEST(SupportedBridge, InnerPointsGoAlongLessTheFurtherTheyAre)
{
  const Islands caps = twoCaps();
  Bridge bridge;
  bridge.begin = caps.targets.pointAt(0, 0.02);
  bridge.end = caps.targets.pointAt(1, 0.0);
  for (const double share : {0.0, 0.25, 0.5, 1.0})
    bridge.points.push_back((1.0 - share) * bridge.begin.position +
                            share * bridge.end.position);
  const Bridge moved = supportedByVertices(bridge, caps.targets);
  const Eigen::Vector3d shift = moved.points.front() - bridge.points.front();
  ASSERT_GT(shift.norm(), 0.0);
  EXPECT_NEAR(0.0, (moved.points[1] - bridge.points[1] - 0.75 * shift).norm(), 1e-12);
  EXPECT_NEAR(0.0, (moved.points[2] - bridge.points[2] - 0.5 * shift).norm(), 1e-12);
  EXPECT_EQ(bridge.points.back(), moved.points.back());
}

TEST(BridgeSelection, BridgeHasTheLineOfItsForceLine)
{
  const Islands caps = twoCaps();
  const ForceLine line = linesOf(caps).front();
  const Bridge bridge = bridgeAlong(line);
  EXPECT_EQ(line.points, bridge.points);
  EXPECT_EQ(line.target.edge, bridge.end.edge);
}

} // namespace
} // namespace pcl::repair
