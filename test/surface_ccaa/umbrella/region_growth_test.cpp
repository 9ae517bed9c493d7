// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of condition C3.4-3.
#include "filter_helpers.h"

namespace pcl::ccaa::test {
namespace {

TEST(RegionGrowth, KeepsARegionWithExactlyEnoughInternalPoints)
{
  const auto shape = grid(7, 4); // 5 * 2 internal points
  const auto result = filtered(shape, 10);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), shape.triangles.size());
  EXPECT_EQ(result.report.internal_points, 10u);
  EXPECT_EQ(result.report.components, 1u);
}

TEST(RegionGrowth, DropsARegionWithOneInternalPointLess)
{
  const auto shape = grid(7, 4);
  const auto result = filtered(shape, 11);
  expectCertified(shape, result);
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.report.small_region_triangles, shape.triangles.size());
  EXPECT_EQ(result.report.free_points, shape.vertices.size());
  EXPECT_EQ(result.report.components, 0u);
}

TEST(RegionGrowth, HasTenAsDefault)
{
  EXPECT_EQ(UmbrellaFilter().getMinimumInternalPoints(), 10u);
}

TEST(RegionGrowth, JudgesEachRegionByItself)
{
  const auto small = grid(3, 3);
  const auto large = translated(icosphere(1), {10.0, 0.0, 0.0});
  const auto shape = joined(joined(small, large), translated(small, {0.0, 9.0, 0.0}));
  const auto result = filtered(shape, 2);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), large.triangles.size());
  EXPECT_EQ(result.report.small_region_triangles, 2 * small.triangles.size());
}

TEST(RegionGrowth, KeepsLonelyTrianglesWhenSwitchedOff)
{
  const Shape shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(filtered(shape, 0).triangles.size(), 1u);
  EXPECT_EQ(filtered(shape, 1).triangles.size(), 0u);
}

TEST(RegionGrowth, CountsAfterTheUmbrellaRows)
{
  // two sheets that touch in one point are one region only until row 3 parts them
  auto shape = joined(grid(4, 4), translated(grid(3, 3), {3.0, 3.0, 0.0}));
  for (auto& triangle : shape.triangles)
    std::replace(triangle.begin(), triangle.end(), 16, 15);
  const auto result = filtered(shape, 4);
  expectCertified(shape, result);
  EXPECT_EQ(result.report.internal_points, 4u);
}

} // namespace
} // namespace pcl::ccaa::test
