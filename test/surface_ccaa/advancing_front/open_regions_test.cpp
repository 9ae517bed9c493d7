// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far samples lie apart, and gaps apart from each other.
#include <gtest/gtest.h>

#include "advancing_front/open_regions.h"
#include "advancing_front/spacing.h"
#include "open_shapes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::ccaa::test {
namespace {

TEST(Spacing, OfAFreePointIsTheRootMeanSquareToItsNeighbors)
{
  const OpenSurface open = openPoints(grid(9, 9).vertices);
  // four at distance 1, two of those at sqrt 2
  EXPECT_NEAR(open.spacings[40], std::sqrt((4.0 * 1.0 + 2.0 * 2.0) / 6.0), 1e-12);
  EXPECT_EQ(spacingFromNeighbors(open, 40), open.spacings[40]);
}

TEST(Spacing, AtABorderIsTheMeanOfTheShorterHalfOfTheEdges)
{
  std::vector<index_t> vertices;
  const OpenSurface open = openSurfaceOf(grid(9, 9), vertices);
  const auto place = std::find(vertices.begin(), vertices.end(), 4);
  EXPECT_NEAR(open.spacings[std::size_t(place - vertices.begin())], 1.0, 1e-12);
}

TEST(Spacing, OfALonePointIsZero)
{
  EXPECT_EQ(openPoints({{1, 2, 3}}).spacings[0], 0.0);
}

TEST(Spacing, IsKeptWhereItIsKnown)
{
  OpenSurface open = openPoints(grid(9, 9).vertices);
  open.spacings[40] = 0.125;
  completeSpacings(open);
  EXPECT_EQ(open.spacings[40], 0.125);
}

/** Gaps in a floor, some next to each other, some far apart. */
Shape
floorWithGaps(std::uint64_t seed)
{
  return withoutPatches(grid(40, 40), 12, 1, seed);
}

TEST(OpenRegions, HoldEveryOpenPointOnce)
{
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const OpenSurface open = openSurfaceOf(floorWithGaps(seed));
    std::vector<index_t> all;
    for (const auto& region : openRegions(open, 4.0)) {
      EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
      all.insert(all.end(), region.begin(), region.end());
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), open.open_points);
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_EQ(all[i], static_cast<index_t>(i));
  }
}

TEST(OpenRegions, AreTwoForTwoGapsFarApart)
{
  Shape floors = joined(grid(5, 5), translated(grid(5, 5), {50, 0, 0}));
  EXPECT_EQ(openRegions(openSurfaceOf(floors), 4.0).size(), 2u);
  floors = joined(grid(5, 5), translated(grid(5, 5), {6, 0, 0}));
  EXPECT_EQ(openRegions(openSurfaceOf(floors), 4.0).size(), 1u);
}

TEST(OpenRegions, AreOrderedByTheirFirstPoint)
{
  const OpenSurface open = openSurfaceOf(floorWithGaps(3));
  const auto regions = openRegions(open, 1.5);
  EXPECT_GT(regions.size(), 2u);
  for (std::size_t i = 1; i < regions.size(); ++i)
    EXPECT_LT(regions[i - 1].front(), regions[i].front());
}

TEST(OpenRegions, ShareNoTriangleOfTheRim)
{
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const OpenSurface open = openSurfaceOf(floorWithGaps(seed));
    const auto regions = openRegions(open, 1.5);
    std::vector<std::size_t> region_of(open.open_points);
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (const index_t point : regions[r])
        region_of[std::size_t(point)] = r;
    const auto rims = rimOfRegions(open, regions);
    ASSERT_EQ(rims.size(), regions.size());
    std::set<index_t> seen;
    for (std::size_t r = 0; r < rims.size(); ++r)
      for (const index_t t : rims[r]) {
        EXPECT_TRUE(seen.insert(t).second);
        for (const index_t corner : open.rim[std::size_t(t)])
          if (static_cast<std::size_t>(corner) < open.open_points) {
            EXPECT_EQ(region_of[std::size_t(corner)], r);
          }
      }
    EXPECT_EQ(seen.size(), open.rim.size());
  }
}

TEST(OpenRegions, BecomeOpenSurfacesOfTheirOwn)
{
  const OpenSurface open = openSurfaceOf(floorWithGaps(3));
  const auto regions = openRegions(open, 1.5);
  const auto rims = rimOfRegions(open, regions);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    std::vector<index_t> vertices;
    const OpenSurface own = regionOf(open, regions[r], rims[r], vertices);
    ASSERT_EQ(own.open_points, regions[r].size());
    ASSERT_EQ(own.positions.size(), vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
      EXPECT_EQ(own.positions[v], open.positions[std::size_t(vertices[v])]);
    for (std::size_t i = 0; i < own.open_points; ++i) {
      EXPECT_EQ(vertices[i], regions[r][i]);
      EXPECT_EQ(own.spacings[i], open.spacings[std::size_t(vertices[i])]);
    }
    ASSERT_EQ(own.rim.size(), rims[r].size());
    for (std::size_t t = 0; t < own.rim.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(vertices[std::size_t(own.rim[t][c])],
                  open.rim[std::size_t(rims[r][t])][c]);
  }
}

} // namespace
} // namespace pcl::ccaa::test
