// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the falloffs (4.45).
#include <gtest/gtest.h>

#include "field/falloff.h"

namespace pcl::repair::test {
namespace {

const Falloff SAMPLE{0.1, 0.5, 2.5};

TEST(Falloff, IsOneUpToNear)
{
  EXPECT_EQ(SAMPLE(0.0), 1.0);
  EXPECT_EQ(SAMPLE(0.1), 1.0);
}

TEST(Falloff, IsZeroFromFarOn)
{
  EXPECT_EQ(SAMPLE(0.5), 0.0);
  EXPECT_EQ(SAMPLE(1e300), 0.0);
}

TEST(Falloff, NeverGrowsAndIsNeverNegative)
{
  double before = 1.0;
  for (double distance = 0.0; distance < 0.6; distance += 0.001) { // E4.423-2
    EXPECT_LE(SAMPLE(distance), before);
    EXPECT_GE(SAMPLE(distance), 0.0);
    before = SAMPLE(distance);
  }
}

TEST(Falloff, FallsWithItsPower)
{
  EXPECT_NEAR(SAMPLE(0.3), std::pow(0.5, 2.5), 1e-15); // E4.45-1b
}

TEST(Falloff, OfNoWidthIsAStep)
{
  const Falloff step{0.5, 0.5, 2.5};
  EXPECT_EQ(step(0.49999), 1.0);
  EXPECT_EQ(step(0.5), 0.0);
}

TEST(Falloff, TrustGivesTheTensionAtAFreePoint)
{
  EXPECT_EQ(trustedTension(0.0), 0.0);
  EXPECT_EQ(trustedTension(0.5), 1.0); // E4.424-1c
}

} // namespace
} // namespace pcl::repair::test
