// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: when the origin counts as the sensor's place.
#include <gtest/gtest.h>

#include "mesh/side_hints.h"
#include "support/clouds.h"
#include "support/single_view.h"

#include <limits>

namespace pcl::ccaa::test {
namespace {

TEST(Origin, HasCloudsOfSensorsBeforeIt)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    EXPECT_TRUE(liesBeforeOrigin(inSensorFrame(singleView(seed, 60)).points)) << seed;
}

TEST(Origin, HasNoCloudBeforeItThatLiesAroundIt)
{
  EXPECT_FALSE(liesBeforeOrigin(fibonacciSphere(2000)));
  EXPECT_FALSE(liesBeforeOrigin(shifted(fibonacciSphere(2000), {0.0, 0.0, 1.2})));
}

TEST(Origin, HasNoClosedBodyBeforeIt)
{
  EXPECT_FALSE(liesBeforeOrigin(shifted(fibonacciSphere(2000), {0.0, 0.0, 5.0})));
  EXPECT_FALSE(liesBeforeOrigin(shifted(torusCloud(3000), {4.0, 3.0, 0.0})));
}

TEST(Origin, HasNoCloudInMapCoordinatesBeforeIt)
{
  EXPECT_FALSE(liesBeforeOrigin(shifted(terrainCloud(30), {5e5, 4e6, 200.0})));
}

TEST(Origin, HasNothingBeforeItWithoutPoints)
{
  EXPECT_FALSE(liesBeforeOrigin(Positions()));
  EXPECT_FALSE(liesBeforeOrigin(Positions(3, Position::Zero())));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(liesBeforeOrigin(Positions(3, Position(nan, 0.0, 1.0))));
}

TEST(Origin, IsAskedForTheChosenPointsOnly)
{
  Positions points = inSensorFrame(singleView(1, 60)).points;
  Indices chosen(points.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = static_cast<index_t>(i);
  points.emplace_back(0.0, 0.0, 0.001);
  EXPECT_FALSE(liesBeforeOrigin(points));
  EXPECT_TRUE(liesBeforeOrigin(points, &chosen));
}

TEST(Origin, IsNotTakenWhereAnythingIsTold)
{
  const Positions points = inSensorFrame(singleView(1, 60)).points;
  SideHints hints;
  hints.try_origin = true;
  hints.up = Position::UnitZ();
  takeOrigin(hints, points);
  EXPECT_FALSE(hints.viewpoint_is_origin);
  hints.up.reset();
  takeOrigin(hints, points);
  EXPECT_TRUE(hints.viewpoint_is_origin);
}

TEST(SideTallyText, HasTheRuleOfMostTrianglesFirst)
{
  SideTally tally;
  EXPECT_EQ("", describe(tally));
  tally.triangles[static_cast<std::size_t>(OutwardRule::VOLUME)] = 1;
  EXPECT_EQ("enclosed volume", describe(tally));
  tally.triangles[static_cast<std::size_t>(OutwardRule::BULGE)] = 3;
  EXPECT_EQ("bulge (75 %), enclosed volume (25 %)", describe(tally));
}

} // namespace
} // namespace pcl::ccaa::test
