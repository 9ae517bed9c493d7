// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of closing the holes of a region.

#include <gtest/gtest.h>

#include "region/region_parts.h"
#include "support/random_source.h"
#include "surface_repair/boundary/boundary_models.h"
#include "surface_repair/region/closing_site.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::centreOf;
using test::expectSound;
using test::Site;
using test::without;

RepairParameters
unrefined()
{
  RepairParameters parameters;
  parameters.refine = false;
  return parameters;
}

Shape
holedSphere()
{
  return without(icosphere(4), [](const Position& p) { return p.z() > 0.7; });
}

/** A flat sheet with a square hole of a side around the origin. */
Shape
holedSheet(double side)
{
  return without(translated(grid(22, 22), {-10.5, -10.5, 0.0}), [&](const Position& p) {
    return p.lpNorm<Eigen::Infinity>() < 0.5 * side;
  });
}

/** The same with a hole of one square, two opposite corners of which are higher. */
Shape
sheetWithATwistedHole()
{
  Shape shape = holedSheet(1.0);
  for (Position& p : shape.vertices)
    if (p.lpNorm<Eigen::Infinity>() < 0.6 && p.x() * p.y() > 0.0)
      p.z() += 0.5;
  return shape;
}

Shape
twoCaps()
{
  return without(icosphere(4), [](const Position& p) { return std::abs(p.z()) < 0.2; });
}

double
highestOf(const Patch& patch)
{
  double highest = -1e9;
  for (const Position& p : patch.positions)
    highest = std::max(highest, p.z());
  return highest;
}

TEST(RegionClosing, ClosesAHoleAtTheFirstTry)
{
  const Site site(holedSphere());
  const ClosedRegion closed = site.close();
  ASSERT_EQ(1U, closed.holes.size());
  EXPECT_EQ(OpenReason::NONE, closed.holes[0].open);
  EXPECT_EQ(0U, closed.holes[0].tries);
  expectSound(site, closed);
}

TEST(RegionClosing, FairedPatchOfASphereRisesToItsPole)
{
  EXPECT_NEAR(1.0, highestOf(Site(holedSphere()).close().patch), 0.02);
}

TEST(RegionClosing, WithoutRefinementNoVertexIsNew)
{
  const Patch patch = Site(holedSphere(), unrefined()).close().patch;
  EXPECT_EQ(patch.rim.size(), patch.positions.size());
}

TEST(RegionClosing, NewVerticesHavePlacesThatAFloatCanHold)
{
  const Patch patch = Site(holedSphere()).close().patch;
  ASSERT_GT(patch.positions.size(), patch.rim.size());
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      volatile const float held = static_cast<float>(patch.positions[v][axis]);
      EXPECT_EQ(static_cast<double>(held), patch.positions[v][axis]) << v;
    }
}

TEST(RegionClosing, DividesAComplexHole)
{
  RepairParameters parameters;
  parameters.filling.simple_edges = 20;
  const Site site(holedSphere(), parameters);
  const ClosedRegion closed = site.close();
  EXPECT_GT(closed.holes[0].bridges.size(), 1U);
  expectSound(site, closed);
}

/** The faired patch would rise through the spike, the flat one stays below it. */
TEST(RegionClosing, GoesBackWhereFairingWouldRunThroughSomething)
{
  Site site(holedSphere());
  site.putSpike({0.0, 0.0, 1.1}, 0.5);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::NONE, closed.holes[0].open);
  Site open(holedSphere());
  EXPECT_LT(highestOf(closed.patch), highestOf(open.close().patch));
  expectSound(site, closed);
}

/** Of the two ways to fold a square hole the first one is pierced. */
TEST(RegionClosing, ClosesAroundWhatTheFirstFillingWouldRunThrough)
{
  Site site(sheetWithATwistedHole(), unrefined());
  const Patch first = site.close().patch;
  ASSERT_EQ(2U, first.triangles.size());
  Position middle = Position::Zero();
  for (const pcl::index_t corner : first.triangles[0])
    middle += first.positions[static_cast<std::size_t>(corner)] / 3.0;
  site.putSpike(middle, 0.1);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::NONE, closed.holes[0].open);
  EXPECT_FALSE(sameUnorientedTriangles(first.triangles, closed.patch.triangles));
  expectSound(site, closed);
}

TEST(RegionClosing, LeavesOpenWhatNothingCloses)
{
  Site site(holedSheet(7.0));
  site.putSpike({0.2, 0.1, 0.0}, 40.0, 0.1);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::INTERSECTION, closed.holes[0].open);
  EXPECT_GT(closed.holes[0].tries, 1U);
  EXPECT_TRUE(closed.patch.triangles.empty());
  expectSound(site, closed);
}

TEST(RegionClosing, TriesNothingWhereTheSurfaceRunsThroughTheBoundary)
{
  Site site(holedSheet(7.0));
  const BoundaryCurve& rim = site.regions[0].holes[0].curve;
  site.putSpike(rim.points[3] + 0.5 * rim.edge(3), 2.0);
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::PIERCED, closed.holes[0].open);
  EXPECT_EQ(0U, closed.holes[0].tries);
  expectSound(site, closed);
}

/** All four vertices of the polygon have edges to each other already. */
TEST(RegionClosing, AHoleWhoseDiagonalsAreEdgesHasNoFilling)
{
  const Site site(tetrahedron());
  Region region;
  region.holes.emplace_back();
  HolePolygon& hole = region.holes[0];
  hole.vertices = {0, 1, 2, 3};
  hole.curve.points = site.survey.model.positions;
  hole.curve.normals.assign(4, Direction::UnitZ());
  const ClosedRegion closed = site.close(region);
  EXPECT_EQ(OpenReason::NO_FILLING, closed.holes[0].open);
  EXPECT_TRUE(closed.patch.triangles.empty());
}

TEST(RegionClosing, ClosesAllHolesBetweenBridges)
{
  const Site site(twoCaps());
  const ClosedRegion closed = site.close();
  for (const HoleOutcome& hole : closed.holes)
    EXPECT_EQ(OpenReason::NONE, hole.open);
  expectSound(site, closed);
}

TEST(RegionClosing, LeavesOutOnlyTheHoleThatIsObstructed)
{
  Site site(twoCaps());
  const Position middle = centreOf(site.regions[0].holes[0]);
  const Position side = 0.01 * Position::UnitZ();
  site.obstacle.add({0.5 * middle, 1.6 * middle, 1.6 * middle + side}, {{0, 1, 2}});
  const ClosedRegion closed = site.close();
  EXPECT_EQ(OpenReason::INTERSECTION, closed.holes[0].open);
  for (std::size_t h = 1; h < closed.holes.size(); ++h)
    EXPECT_EQ(OpenReason::NONE, closed.holes[h].open) << h;
  expectSound(site, closed);
}

class RandomSpikes : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomSpikes, AreNeverMetByWhatIsKept)
{
  Site site(GetParam() % 2 == 0 ? twoCaps() : holedSphere());
  RandomSource random(GetParam());
  for (int k = 0; k < 12; ++k) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    site.putSpike({x, y, random.uniform(-0.3, 1.0)}, 0.2);
  }
  for (const Region& region : site.regions)
    expectSound(site, site.close(region));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSpikes, ::testing::Range(0U, 8U));

TEST(RegionClosing, EveryMethodAvoidsASpike)
{
  for (const FillingChoice choice :
       {FillingChoice::FAN, FillingChoice::MINIMUM_WEIGHT, FillingChoice::COMPLETION}) {
    RepairParameters parameters;
    parameters.filling.choice = choice;
    Site site(holedSphere(), parameters);
    site.putSpike({0.0, 0.0, 1.1}, 0.5);
    const ClosedRegion closed = site.close();
    EXPECT_EQ(OpenReason::NONE, closed.holes[0].open) << static_cast<int>(choice);
    expectSound(site, closed);
  }
}

TEST(CloseRegion, LeavesOpenWhatWouldTakeTooMuchWork)
{
  const Site site(holedSphere());
  ccaa::RunControl whole;
  site.close(site.regions.at(0), &whole);
  const std::uint64_t work = whole.work();
  for (const std::uint64_t part : {1000, 10, 2}) {
    ccaa::RunControl little(&whole, work / part);
    const ClosedRegion closed = site.close(site.regions.at(0), &little);
    expectSound(site, closed);
    EXPECT_EQ(OpenReason::TOO_COSTLY, closed.holes[0].open);
  }
}

TEST(CloseRegion, TakesNoMoreWorkThanItMayInACrowd)
{
  Site site(holedSheet(20.0));
  ccaa::test::RandomSource random(1);
  const auto place = [&] {
    return Position(random.uniform(-10.0, 10.0),
                    random.uniform(-10.0, 10.0),
                    random.uniform(-1.0, 1.0));
  };
  for (int i = 0; i < 400; ++i)
    site.obstacle.add({place(), place(), place()}, {{0, 1, 2}});
  ccaa::RunControl control;
  const ClosedRegion closed = site.close(site.regions.at(0), &control);
  expectSound(site, closed);
  EXPECT_NE(OpenReason::NONE, closed.holes[0].open);
  const std::uint64_t most = workFor(site.regions.at(0));
  EXPECT_LE(control.work(), most + most / 10);
}

} // namespace
} // namespace pcl::repair
