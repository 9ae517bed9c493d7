// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the reaches derived from the data (4.45).
#include <gtest/gtest.h>

#include "field/reach.h"
#include "field_samples.h"

#include <algorithm>
#include <limits>

namespace pcl::repair::test {
namespace {

double
plainGap(const SourceSet& sources, const Position& position, std::size_t silent)
{
  double gap = std::numeric_limits<double>::infinity();
  for (const SourceCurve& curve : sources.curves)
    if (silent == NONE || curve.island != silent)
      for (const FieldSource& source : curve.sources)
        gap = std::min(gap, (source.position - position).norm());
  return gap;
}

TEST(GapFinder, FindsTheNearestSourceOfAnotherIsland)
{
  const SourceSet sources = randomSources(600, 1);
  const GapFinder finder(sources);
  RandomSource random(2);
  for (std::size_t i = 0; i < 400; ++i) {
    const Position place = 3.0 * randomPosition(random) - Position::Constant(1.0);
    const std::size_t silent = i % 4 == 3 ? NONE : i % 4;
    EXPECT_EQ(finder.gapAt(place, silent), plainGap(sources, place, silent));
  }
}

TEST(GapFinder, FindsTheGapBetweenTwoCaps)
{
  const SourceSet sources = twoCaps(300, 0.2);
  const GapFinder finder(sources);
  for (const FieldSource& source : sources.curves[0].sources)
    EXPECT_NEAR(finder.gapAt(source.position, 0), 0.2, 1e-9);
}

TEST(GapFinder, IsInfiniteWithoutAnotherIsland)
{
  EXPECT_TRUE(std::isinf(GapFinder(SourceSet()).gapAt({0, 0, 0}, 0)));
  SourceSet one = twoCaps(100, 0.2);
  one.curves.resize(1);
  EXPECT_TRUE(std::isinf(GapFinder(one).gapAt({0, 0, 0}, 0)));
  EXPECT_TRUE(std::isfinite(GapFinder(one).gapAt({0, 0, 0}, NONE)));
}

TEST(Reach, LeavesRoomBeyondTheGap)
{
  const Falloff falloff = sourceFalloff(0.1, 2.0);
  EXPECT_EQ(falloff.near, 0.1);
  EXPECT_EQ(falloff.far, 5.0);
  EXPECT_EQ(falloff.exponent, 2.5);
}

TEST(Reach, SpansSeveralSourcesHoweverNarrowTheGap)
{
  EXPECT_EQ(sourceFalloff(0.1, 0.01).far, 0.4);
}

TEST(Reach, IsNothingAcrossAnInfiniteGap)
{
  EXPECT_EQ(sourceFalloff(0.1, std::numeric_limits<double>::infinity())(0.0), 0.0);
}

TEST(Reach, OfFreePointsIsHalfTheGapButNoLessThanTheirSpacing)
{
  EXPECT_EQ(freePointFalloff(0.1, 1.0).far, 0.5);
  EXPECT_EQ(freePointFalloff(0.1, 0.1).far, 0.1);
  EXPECT_EQ(freePointFalloff(0.1, std::numeric_limits<double>::infinity()).far, 0.1);
}

TEST(Reach, TakesTheMeanDistanceOfNearestNeighbours)
{
  EXPECT_EQ(meanSpacing({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3.5, 0, 0}}), 0.75);
  EXPECT_EQ(meanSpacing({{0, 0, 0}}), 0.0);
  EXPECT_EQ(meanSpacing({{1, 1, 1}, {1, 1, 1}}), 0.0);
}

} // namespace
} // namespace pcl::repair::test
