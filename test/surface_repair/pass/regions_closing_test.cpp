// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of closing regions side by side.

#include <gtest/gtest.h>

#include "pass/regions_closing.h"
#include "support/repair_shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "surface_repair/region/closing_site.h"

#include <algorithm>
#include <numeric>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::Site;
using test::without;

/** Small holes around the directions of the axes. */
Site
siteWithSixHoles()
{
  return Site(without(icosphere(4), [](const Position& p) {
    return p.lpNorm<Eigen::Infinity>() > 0.97;
  }));
}

std::vector<ClosedRegion>
closedTogether(const Site& site, int threads, RegionMemory& memory)
{
  const SurveyGuides none;
  const ClosingPlace place{site.survey.model, none, site.parameters, {}};
  return closeRegions(
      place, site.regions, ccaa::LoopContext{threads}, memory, [](double) {});
}

TEST(RegionsClosing, RegionsSideBySideAreClosedAsAlone)
{
  const Site site = siteWithSixHoles();
  ASSERT_EQ(6U, site.regions.size());
  for (const int threads : {1, 2, 5}) {
    RegionMemory memory;
    const std::vector<ClosedRegion> closed = closedTogether(site, threads, memory);
    for (std::size_t r = 0; r < closed.size(); ++r) {
      const ClosedRegion alone = site.close(site.regions[r]);
      EXPECT_EQ(alone.patch.positions, closed[r].patch.positions);
      EXPECT_EQ(alone.patch.triangles, closed[r].patch.triangles);
    }
    EXPECT_TRUE(memory.empty());
  }
}

TEST(RegionsClosing, ARegionSeesThePatchesThatCameBeforeIt)
{
  Site site = siteWithSixHoles();
  site.regions = {site.regions.front(), site.regions.front()};
  RegionMemory memory;
  const std::vector<ClosedRegion> closed = closedTogether(site, 2, memory);
  EXPECT_EQ(OpenReason::NONE, closed[0].holes.front().open);
  SurfaceObstacle first(site.survey.model, {});
  first.add(closed[0].patch.positions, closed[0].patch.triangles);
  EXPECT_TRUE(obstructedTriangles(closed[1].patch, first).empty());
}

/** Each region comes three times: the later ones find the patch of the first. */
TEST(RegionsClosing, RegionsThatAreInTheWayOfEachOtherAreTheSameForAnyThreads)
{
  Site site = siteWithSixHoles();
  const std::vector<Region> once = site.regions;
  for (int more = 0; more < 2; ++more)
    site.regions.insert(site.regions.end(), once.begin(), once.end());
  RegionMemory of_one;
  const std::vector<ClosedRegion> expected = closedTogether(site, 1, of_one);
  for (const int threads : {2, 5, 8}) {
    RegionMemory memory;
    const std::vector<ClosedRegion> closed = closedTogether(site, threads, memory);
    ASSERT_EQ(expected.size(), closed.size());
    for (std::size_t r = 0; r < closed.size(); ++r) {
      EXPECT_EQ(expected[r].patch.positions, closed[r].patch.positions) << r;
      EXPECT_EQ(expected[r].patch.triangles, closed[r].patch.triangles) << r;
    }
  }
}

/** A wall stands in the hole of a sphere; a cluster of free points far above tells
 * nothing. */
Site
siteWithAWallAndStrays()
{
  Shape shape = withoutFreeVertices(
      without(icosphere(3), [](const Position& p) { return p.z() > 0.7; }));
  const auto corner = static_cast<pcl::index_t>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(),
                        {{-0.5, 0, -0.8}, {-0.5, 0, 6}, {-0.5, 0.01, 6}});
  shape.triangles.push_back({corner, corner + 1, corner + 2});
  for (int i = 0; i < 8; ++i)
    shape.vertices.push_back(
        {0.3 + 0.01 * i, 0.01 * (i * i % 5), 2.5 + 0.02 * (i % 3)});
  Site site(shape);
  Region of_sphere = site.regions.front();
  for (const Region& region : site.regions)
    if (region.holes.front().size() > of_sphere.holes.front().size())
      of_sphere = region;
  of_sphere.samples.resize(8);
  std::iota(of_sphere.samples.begin(), of_sphere.samples.end(), std::size_t(0));
  site.regions = {of_sphere};
  return site;
}

TEST(RegionsClosing, WhatFailsWithoutItsStraysIsKnownToFailWithout)
{
  const Site site = siteWithAWallAndStrays();
  RegionMemory memory;
  const std::vector<ClosedRegion> closed = closedTogether(site, 1, memory);
  ASSERT_EQ(OpenReason::INTERSECTION, closed[0].holes.front().open);
  EXPECT_TRUE(closed[0].without_samples);
  const auto* const failure = memory.find(
      RegionMemory::keyOf(withoutSamples(site.regions[0]), site.survey.model));
  ASSERT_NE(nullptr, failure);
  EXPECT_TRUE(failure->seen.contains(Position(-0.5, 0, 0.7)));
}

TEST(RegionsClosing, TellsTheShareThatIsDone)
{
  const Site site = siteWithSixHoles();
  const SurveyGuides none;
  RegionMemory memory;
  std::vector<double> shares;
  closeRegions({site.survey.model, none, site.parameters, {}},
               site.regions,
               ccaa::LoopContext(),
               memory,
               [&](double share) { shares.push_back(share); });
  ASSERT_EQ(6U, shares.size());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_DOUBLE_EQ(1.0, shares.back());
}

} // namespace
} // namespace pcl::repair
