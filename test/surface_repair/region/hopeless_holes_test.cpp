// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of holes of which it is told early that nothing
// closes them.

#include <gtest/gtest.h>

#include "region/hopeless_holes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "surface_repair/region/closing_site.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::centreOf;
using test::expectSound;
using test::Site;
using test::without;

/** A flat sheet with two square holes of 15 edges a side in one region. */
Site
sheetWithTwoHoles()
{
  Site site(
      without(translated(grid(44, 22), {-21.5, -10.5, 0.0}), [](const Position& p) {
        return std::abs(std::abs(p.x()) - 10.5) < 7.5 && std::abs(p.y()) < 7.5;
      }));
  site.regions[0].holes.push_back(site.regions.at(1).holes.at(0));
  site.regions.resize(1);
  return site;
}

/** So many rows of spikes through the first hole. */
void
putRows(int rows, Site& site)
{
  const double middle = centreOf(site.regions[0].holes[0]).x();
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < 40; ++i)
      site.putSpike({middle - 6.3 + 0.32 * i, -6.4 + 0.83 * row, 0.0}, 30.0);
}

TEST(HopelessHoles, AreThoseThatAreFullOfTheSurface)
{
  Site site = sheetWithTwoHoles();
  putRows(16, site);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::INTERSECTION, closed.holes[0].open);
  EXPECT_EQ(1U, closed.holes[0].tries);
  expectSound(site, closed);
}

TEST(HopelessHoles, DoNotKeepOthersOfTheirRegionOpen)
{
  Site site = sheetWithTwoHoles();
  putRows(16, site);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::NONE, closed.holes[1].open);
  EXPECT_FALSE(closed.patch.triangles.empty());
}

/** A fill of 100 triangles, of which the surface is in the way of the first ones, and
 * the next ones of each other. */
std::size_t
hopelessAmong(std::size_t through_surface, std::size_t through_itself)
{
  Patch patch;
  Positions positions;
  Triangles spikes;
  const auto add = [&](const Position& place, bool upright) {
    const auto first = static_cast<pcl::index_t>(patch.positions.size());
    patch.positions.push_back(place);
    patch.positions.push_back(place + Position(0.5, 0.0, 0.0));
    patch.positions.push_back(
        place + (upright ? Position(0.2, 0.1, 0.5) : Position(0.2, 0.5, 0.0)));
    patch.triangles.push_back({first, first + 1, first + 2});
    patch.hole.push_back(7);
  };
  for (std::size_t i = 0; i < 100; ++i) {
    const Position place(static_cast<double>(i), 0.0, 0.0);
    const bool is_crossed =
        i >= through_surface && i < through_surface + through_itself;
    if (is_crossed && (i - through_surface) % 2 == 1)
      add(place - Position(1.0, -0.1, 0.2), true);
    else
      add(place, false);
    if (i >= through_surface)
      continue;
    const auto first = static_cast<pcl::index_t>(positions.size());
    for (const double height : {-1.0, 1.0})
      positions.push_back(place + Position(0.2, 0.2, height));
    positions.push_back(place + Position(0.21, 0.2, 1.0));
    spikes.push_back({first, first + 1, first + 2});
  }
  patch.free_point.assign(patch.positions.size(), NONE);
  SurfaceObstacle obstacle{IncompleteModel(), {}};
  if (!spikes.empty())
    obstacle.add(positions, spikes);
  EXPECT_EQ(through_surface + through_itself,
            obstructedTriangles(patch, obstacle).size());
  return hopelessHoles(patch, obstacle).size();
}

TEST(HopelessHoles, RunThroughTheSurfaceInMoreThanThirtyTwoPlaces)
{
  EXPECT_EQ(0U, hopelessAmong(32, 0));
  EXPECT_EQ(1U, hopelessAmong(33, 0));
}

TEST(HopelessHoles, AreNoneThatRunThroughThemselvesOnly)
{
  EXPECT_EQ(0U, hopelessAmong(0, 80));
  EXPECT_EQ(0U, hopelessAmong(20, 60));
}

} // namespace
} // namespace pcl::repair
