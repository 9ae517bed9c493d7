// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of extracting the contours of holes.

#include <gtest/gtest.h>

#include "hole/hole_contour.h"
#include "surface_repair/force_line/sphere_rims.h"

#include <algorithm>
#include <map>
#include <random>

namespace pcl::repair {
namespace {

using test::sphereRim;

constexpr std::size_t COUNT = 48;

/** Rims of an upper and a lower cap, moved along x; curve 2 k is the upper one of the
 * k-th sphere, 2 k + 1 the lower one. */
BoundaryEdges
capsOf(std::size_t spheres)
{
  std::vector<TargetCurve> curves;
  for (std::size_t k = 0; k < 2 * spheres; ++k) {
    const bool is_above = k % 2 == 0;
    BoundaryCurve rim = sphereRim(is_above ? 0.3 : -0.3, is_above, COUNT);
    for (Position& point : rim.points)
      point.x() += 3.0 * static_cast<double>(k / 2);
    curves.push_back({rim, k});
  }
  return BoundaryEdges(std::move(curves));
}

/** A straight bridge between two places, given by their share of the whole curve. */
Bridge
bridgeBetween(const BoundaryEdges& boundaries,
              std::size_t from,
              double from_share,
              std::size_t to,
              double to_share)
{
  Bridge bridge;
  bridge.begin = boundaries.pointAt(from, from_share * boundaries.lengthOf(from));
  bridge.end = boundaries.pointAt(to, to_share * boundaries.lengthOf(to));
  bridge.points = {bridge.begin.position,
                   0.5 * (bridge.begin.position + bridge.end.position),
                   bridge.end.position};
  bridge.normals.assign(3, bridge.points[1].normalized());
  return bridge;
}

/** Bridges between the caps of a sphere at equal steps; the lower rim runs the other
 * way round. */
std::vector<Bridge>
bridgesOf(const BoundaryEdges& boundaries, std::size_t sphere, std::size_t count)
{
  std::vector<Bridge> bridges;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = (static_cast<double>(k) + 0.37) / static_cast<double>(count);
    bridges.push_back(
        bridgeBetween(boundaries, 2 * sphere, share, 2 * sphere + 1, 1.0 - share));
  }
  return bridges;
}

/** C4.47-3: how often the contours pass each bridge, the greatest number in one. */
std::map<std::size_t, std::size_t>
passages(const ContourExtraction& extraction)
{
  std::map<std::size_t, std::size_t> passed;
  for (const HoleContour& contour : extraction.contours)
    for (const ContourStep& step : contour.steps)
      if (step.bridge != NONE)
        ++passed[step.bridge];
  return passed;
}

bool
passesABridgeTwice(const HoleContour& contour)
{
  std::vector<std::size_t> passed;
  for (const ContourStep& step : contour.steps)
    passed.push_back(step.bridge);
  std::sort(passed.begin(), passed.end());
  return std::adjacent_find(passed.begin(), passed.end()) != passed.end();
}

/** Length of all sections of one curve. */
double
coveredLength(const ContourExtraction& extraction,
              const BoundaryEdges& boundaries,
              std::size_t curve)
{
  double covered = 0.0;
  for (const HoleContour& contour : extraction.contours)
    for (const ContourStep& step : contour.steps) {
      if (step.section.from.curve != curve)
        continue;
      const double length =
          boundaries.arcAt(step.section.to) - boundaries.arcAt(step.section.from);
      covered += length > 0.0 ? length : length + boundaries.lengthOf(curve);
    }
  return covered;
}

void
expectSoundContours(const ContourExtraction& extraction,
                    const BoundaryEdges& boundaries)
{
  for (const HoleContour& contour : extraction.contours)
    EXPECT_FALSE(passesABridgeTwice(contour));
  for (const auto& [bridge, times] : passages(extraction))
    EXPECT_EQ(2U, times) << "bridge " << bridge;
  for (std::size_t curve = 0; curve < boundaries.curves().size(); ++curve)
    EXPECT_NEAR(boundaries.lengthOf(curve),
                coveredLength(extraction, boundaries, curve),
                1e-9 * boundaries.lengthOf(curve));
}

TEST(ContourExtraction, BridgesOverABeltMakeAsManyHoles)
{
  const BoundaryEdges caps = capsOf(1);
  const ContourExtraction found = extractContours(caps, bridgesOf(caps, 0, 5));
  EXPECT_EQ(5U, found.contours.size());
  EXPECT_TRUE(found.removed_bridges.empty());
  expectSoundContours(found, caps);
}

TEST(ContourExtraction, EachHoleOfABeltHasTwoBridgesAndTwoSections)
{
  const BoundaryEdges caps = capsOf(1);
  for (const HoleContour& contour :
       extractContours(caps, bridgesOf(caps, 0, 5)).contours) {
    ASSERT_EQ(2U, contour.steps.size());
    EXPECT_NE(contour.steps[0].section.from.curve, contour.steps[1].section.from.curve);
  }
}

TEST(ContourExtraction, OneBridgeAloneIsPassedTwiceAndDeleted)
{
  const BoundaryEdges caps = capsOf(1);
  const ContourExtraction found = extractContours(caps, bridgesOf(caps, 0, 1));
  EXPECT_EQ((std::vector<std::size_t>{0}), found.removed_bridges);
  EXPECT_EQ(2U, found.contours.size());
  expectSoundContours(found, caps);
}

TEST(ContourExtraction, WrongBridgeBetweenTwoContoursIsDeleted)
{
  const BoundaryEdges caps = capsOf(2);
  std::vector<Bridge> bridges = bridgesOf(caps, 0, 4);
  for (const Bridge& bridge : bridgesOf(caps, 1, 4))
    bridges.push_back(bridge);
  bridges.push_back(bridgeBetween(caps, 0, 0.01, 2, 0.51)); // L4.47-1
  const ContourExtraction found = extractContours(caps, bridges);
  EXPECT_EQ((std::vector<std::size_t>{8}), found.removed_bridges);
  EXPECT_EQ(8U, found.contours.size());
  expectSoundContours(found, caps);
}

TEST(ContourExtraction, WrongBridgeBetweenNeighbouringHolesTakesTheSharedOneAlong)
{
  const BoundaryEdges caps = capsOf(1);
  std::vector<Bridge> bridges = bridgesOf(caps, 0, 5);
  // Both supports on the upper rim, on either side of bridge 1.
  bridges.push_back(bridgeBetween(caps, 0, 0.2, 0, 0.34));
  const ContourExtraction found = extractContours(caps, bridges);
  EXPECT_TRUE(std::count(
      found.removed_bridges.begin(), found.removed_bridges.end(), std::size_t{5}));
  expectSoundContours(found, caps);
}

TEST(ContourExtraction, BoundaryWithoutABridgeIsAContourByItself)
{
  const BoundaryEdges caps = capsOf(2);
  const ContourExtraction found = extractContours(caps, bridgesOf(caps, 0, 3));
  EXPECT_EQ(3U + 2U, found.contours.size());
  expectSoundContours(found, caps);
}

TEST(ContourExtraction, OfTwoBridgesAtOnePointTheLaterOneGoes)
{
  const BoundaryEdges caps = capsOf(1);
  std::vector<Bridge> bridges = bridgesOf(caps, 0, 4);
  bridges.push_back(bridges[2]);
  EXPECT_EQ((std::vector<std::size_t>{4}),
            extractContours(caps, bridges).removed_bridges);
}

TEST(ContourExtraction, BridgeAcrossAHoleSplitsIt)
{
  const BoundaryEdges caps = capsOf(1);
  const ContourExtraction found =
      extractContours(caps, {bridgeBetween(caps, 0, 0.1, 0, 0.6)});
  EXPECT_EQ(2U + 1U, found.contours.size()); // the other rim is the third
  expectSoundContours(found, caps);
}

class RandomBridges : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomBridges, EndInSoundContours)
{
  const BoundaryEdges caps = capsOf(2);
  std::mt19937 generator(GetParam());
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Bridge> bridges;
  for (int k = 0; k < 20; ++k) {
    const std::size_t from = generator() % 4;
    const std::size_t to = generator() % 4;
    const double begin = share(generator);
    bridges.push_back(bridgeBetween(caps, from, begin, to, share(generator)));
  }
  expectSoundContours(extractContours(caps, bridges), caps);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBridges, ::testing::Range(0U, 30U));

TEST(ContourCurve, HasThePointsOfItsSectionsAndBridges)
{
  const BoundaryEdges caps = capsOf(1);
  const std::vector<Bridge> bridges = bridgesOf(caps, 0, 5);
  std::size_t points = 0;
  for (const HoleContour& contour : extractContours(caps, bridges).contours)
    points += curveOf(contour, caps, bridges).size();
  // Each vertex once; each bridge twice with its three points.
  EXPECT_EQ(2 * COUNT + 2 * 5 * 3, points);
}

TEST(ContourCurve, SupportingPointsKeepTheirBits)
{
  const BoundaryEdges caps = capsOf(1);
  const std::vector<Bridge> bridges = bridgesOf(caps, 0, 5);
  const HoleContour contour = extractContours(caps, bridges).contours.front();
  const BoundaryCurve curve = curveOf(contour, caps, bridges);
  for (const ContourStep& step : contour.steps)
    EXPECT_EQ(1,
              std::count(curve.points.begin(),
                         curve.points.end(),
                         bridges[step.bridge].points.back()));
}

TEST(ContourCurve, IsClosedWithoutARepeatedPoint)
{
  const BoundaryEdges caps = capsOf(1);
  const std::vector<Bridge> bridges = bridgesOf(caps, 0, 5);
  for (const HoleContour& contour : extractContours(caps, bridges).contours) {
    const BoundaryCurve curve = curveOf(contour, caps, bridges);
    for (std::size_t k = 0; k < curve.size(); ++k)
      EXPECT_GT(curve.edge(k).norm(), 1e-6);
  }
}

TEST(ContourCurve, OfALoneBoundaryIsThatBoundary)
{
  const BoundaryEdges caps = capsOf(1);
  const ContourExtraction found = extractContours(caps, {});
  EXPECT_EQ(caps.curves()[0].curve.points, curveOf(found.contours[0], caps, {}).points);
}

TEST(ContourCurve, EdgesOfABridgeHaveItsNormals)
{
  const BoundaryEdges caps = capsOf(1);
  const std::vector<Bridge> bridges = bridgesOf(caps, 0, 5);
  const BoundaryCurve curve =
      curveOf(extractContours(caps, bridges).contours[0], caps, bridges);
  for (const Direction& normal : curve.normals)
    EXPECT_NEAR(1.0, normal.norm(), 1e-12);
}

} // namespace
} // namespace pcl::repair
