// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of triangles all around between two loops.

#include <gtest/gtest.h>

#include "filling/disc_check.h"
#include "filling/ring_stitching.h"

#include <cmath>

namespace pcl::repair {
namespace {

/** Two circles around the z axis, one some way above the other, cut open. */
BoundaryCurve
cutRing(std::size_t lower, std::size_t upper, double height)
{
  BoundaryCurve ring;
  const auto add = [&](double angle, double z) {
    ring.points.emplace_back(std::cos(angle), std::sin(angle), z);
    ring.normals.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  };
  for (std::size_t i = 0; i <= lower; ++i)
    add(2.0 * M_PI * static_cast<double>(i) / static_cast<double>(lower), 0.0);
  for (std::size_t i = 0; i <= upper; ++i)
    add(-2.0 * M_PI * static_cast<double>(i) / static_cast<double>(upper), height);
  return ring;
}

TEST(StitchRing, IsADiscWithOneTriangleForEachEdgeOfTheLoops)
{
  for (const std::size_t upper : {3U, 7U, 12U, 40U})
    for (const double height : {0.1, 10.0}) {
      const BoundaryCurve ring = cutRing(12, upper, height);
      const Filling filling = stitchRing(ring, 13);
      EXPECT_TRUE(filling.closed());
      EXPECT_EQ(12 + upper, filling.triangles.size());
      EXPECT_TRUE(isDisc(filling, ring.size()));
    }
}

/** The tube of two equal prisms has straight rungs: its area is that of the prism. */
TEST(StitchRing, MakesTheTubeThatItsLoopsAreTheEndsOf)
{
  const BoundaryCurve ring = cutRing(12, 12, 5.0);
  double area = 0.0;
  for (const Triangle& t : stitchRing(ring, 13).triangles) {
    const Position& a = ring.points[static_cast<std::size_t>(t[0])];
    const Position& b = ring.points[static_cast<std::size_t>(t[1])];
    const Position& c = ring.points[static_cast<std::size_t>(t[2])];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  EXPECT_NEAR(12.0 * 2.0 * std::sin(M_PI / 12.0) * 5.0, area, 1e-9);
}

} // namespace
} // namespace pcl::repair
