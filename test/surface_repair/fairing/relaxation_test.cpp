// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the relaxation of patches.
#include <gtest/gtest.h>

#include "fairing/refinement.h"
#include "fairing/relaxation.h"
#include "fairing_samples.h"
#include "support/random_source.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair::test {
namespace {

double
offSphere(const Position& position)
{
  return std::abs(position.norm() - 1.0);
}

PatchedHole
refined(PatchedHole hole)
{
  refinePatch(hole.model, {}, hole.patch);
  return hole;
}

TEST(RelaxPatch, LeavesThePlaneAPlane)
{
  PatchedHole hole = refined(holedPlane(12, 8.0));
  EXPECT_TRUE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
  EXPECT_LT(largestOf(hole.patch, [](const Position& p) { return std::abs(p.z()); }),
            1e-9 * 16.0);
}

TEST(RelaxPatch, FindsTheCapOfASphere)
{
  for (const double angle : {0.3, 0.7, 1.2}) {
    PatchedHole hole = refined(cappedSphere(4, angle));
    EXPECT_TRUE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
    EXPECT_LT(largestOf(hole.patch, offSphere), 0.01 * angle * angle) << angle;
  }
}

TEST(RelaxPatch, DoesNotContinueAPeakBesideTheRim)
{
  PatchedHole hole = refined(cappedSphere(4, 0.7));
  const auto heightOf = [](const Position& p) { return std::abs(p.z() - 0.68); };
  Positions& positions = hole.model.positions;
  *std::min_element(
      positions.begin(), positions.end(), [&](const auto& a, const auto& b) {
        return heightOf(a) < heightOf(b);
      }) *= 1.5;
  relaxPatch(hole.model, {}, {}, hole.patch);
  EXPECT_LT(largestOf(hole.patch, offSphere), 0.002);
}

TEST(RelaxPatch, MovesNoHeldVertex)
{
  PatchedHole hole = refined(cappedSphere(4, 0.7));
  const std::size_t held = hole.patch.positions.size() - 5;
  hole.patch.free_point[held] = 0;
  const Positions before = hole.patch.positions;
  relaxPatch(hole.model, {}, {}, hole.patch);
  for (std::size_t v = 0; v < hole.patch.rim.size(); ++v)
    EXPECT_EQ(hole.patch.positions[v], before[v]);
  EXPECT_EQ(hole.patch.positions[held], before[held]);
}

TEST(RelaxPatch, LeavesAPatchOfHeldVerticesAlone)
{
  PatchedHole hole = withStrip(ccaa::test::icosphere(3),
                               [](const Position& p) { return p.z() > 0.85; });
  const Positions before = hole.patch.positions;
  EXPECT_FALSE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
  EXPECT_EQ(hole.patch.positions, before);
}

TEST(RelaxPatch, FindsTheWallOfACylinder)
{
  PatchedHole hole =
      refined(withFan(ccaa::test::cylinder(60, 60, 1.0, 6.0), [](const Position& p) {
        return p.x() > 0.5 && std::abs(p.z() - 3.0) < 0.7;
      }));
  EXPECT_TRUE(relaxPatch(hole.model, {}, {}, hole.patch).solved);
  EXPECT_LT(largestOf(hole.patch,
                      [](const Position& p) {
                        return std::abs(std::hypot(p.x(), p.y()) - 1.0);
                      }),
            0.02);
}

/** A shape that is an eighth off the sphere where it is lost, in the middle. */
double
dented(const Position& p)
{
  const double t = std::max(0.0, p.normalized().z() - 0.75) / 0.25;
  return 1.0 - 0.125 * t * t;
}

Positions
samplesOf(const PatchedHole& hole, std::size_t step, double noise)
{
  ccaa::test::RandomSource random(4);
  Positions samples;
  for (std::size_t i = 0; i < hole.lost.size(); i += step) {
    const double factor = dented(hole.lost[i]) + noise * random.normal();
    samples.push_back(factor * hole.lost[i]);
  }
  return samples;
}

double
offDent(const Position& p)
{
  return std::abs(p.norm() - dented(p));
}

TEST(RelaxPatch, PassesThroughExactFreePoints)
{
  PatchedHole hole = refined(cappedSphere(4, 0.9));
  const RelaxationReport report =
      relaxPatch(hole.model, samplesOf(hole, 10, 0.0), {}, hole.patch);
  EXPECT_GT(report.free_points, 20u);
  EXPECT_LT(largestOf(hole.patch, offDent), 0.02);
}

TEST(RelaxPatch, AveragesNoisyFreePoints)
{
  PatchedHole hole = refined(cappedSphere(4, 0.9));
  relaxPatch(hole.model, samplesOf(hole, 2, 0.03), {}, hole.patch);
  EXPECT_LT(largestOf(hole.patch, offDent), 0.03);
}

TEST(RelaxPatch, TrustsNoFreePointsWithoutTrust)
{
  PatchedHole hole = refined(cappedSphere(4, 0.9)), other = hole;
  RelaxationParameters parameters;
  parameters.trust = 0.0;
  const Positions samples = samplesOf(hole, 10, 0.0);
  EXPECT_EQ(relaxPatch(hole.model, samples, parameters, hole.patch).free_points, 0u);
  relaxPatch(other.model, {}, {}, other.patch);
  EXPECT_EQ(hole.patch.positions, other.patch.positions);
}

TEST(RelaxPatch, MakesNoSpikeOfASingleOutlier)
{
  for (const double height : {1.05, 1.1, 1.3, 5.0}) {
    PatchedHole hole = refined(cappedSphere(4, 0.7));
    relaxPatch(hole.model, {{0.05, 0.02, height}}, {}, hole.patch);
    EXPECT_LT(largestOf(hole.patch, offSphere), 0.02) << height;
  }
}

TEST(RelaxPatch, HeedsNoOutlierAmongFreePoints)
{
  PatchedHole hole = refined(cappedSphere(4, 0.9));
  Positions samples = samplesOf(hole, 5, 0.0);
  samples.push_back(1.15 * samples[7]);
  relaxPatch(hole.model, samples, {}, hole.patch);
  EXPECT_LT(largestOf(hole.patch, offDent), 0.02);
}

TEST(RelaxPatch, HeedsNoPointOfTheModel)
{
  PatchedHole hole = refined(cappedSphere(4, 0.7));
  EXPECT_EQ(relaxPatch(hole.model, hole.model.positions, {}, hole.patch).free_points,
            0u);
  EXPECT_LT(largestOf(hole.patch, offSphere), 0.01);
}

TEST(RelaxPatch, KnowsNeitherUnitNorPlace)
{
  PatchedHole hole = refined(cappedSphere(3, 0.9));
  relaxPatch(hole.model, {}, {}, hole.patch);
  for (const double scale : {1e-4, 1.0, 1e6}) {
    const Position place = scale * Position(1e5, -1e5, 1e5);
    PatchedHole other = cappedSphere(3, 0.9);
    for (Positions* positions : {&other.model.positions, &other.patch.positions})
      for (Position& p : *positions)
        p = scale * p + place;
    other = refined(other);
    ASSERT_TRUE(relaxPatch(other.model, {}, {}, other.patch).solved);
    for (Position& p : other.patch.positions)
      p = (p - place) / scale;
    EXPECT_LT(largestOf(other.patch, offSphere), 0.01) << scale;
  }
}

TEST(RelaxPatch, GivesTheSameOnceMore)
{
  PatchedHole one = refined(cappedSphere(4, 0.9)), other = one;
  const Positions samples = samplesOf(one, 7, 0.01);
  relaxPatch(one.model, samples, {}, one.patch);
  relaxPatch(other.model, samples, {}, other.patch);
  EXPECT_EQ(one.patch.positions, other.patch.positions);
}

TEST(RelaxPatch, LeavesThePatchAsItIsWhereItIsLeftBeforeTheFirstSurface)
{
  const PatchedHole hole = refined(cappedSphere(5, 1.2));
  ccaa::RunControl whole;
  Patch relaxed = hole.patch;
  ASSERT_TRUE(relaxPatch(hole.model, {}, {}, relaxed, &whole).solved);
  for (const std::uint64_t share : {1000, 100, 30}) {
    ccaa::RunControl control(nullptr, whole.work() / share);
    Patch patch = hole.patch;
    EXPECT_FALSE(relaxPatch(hole.model, {}, {}, patch, &control).solved) << share;
    EXPECT_EQ(hole.patch.positions, patch.positions) << share;
    EXPECT_LT(control.work(), whole.work()) << share;
  }
}

TEST(RelaxPatch, SurvivesPointsOfThePatchAtOnePlace)
{
  PatchedHole hole = refined(cappedSphere(3, 0.9));
  for (std::size_t v = hole.patch.rim.size(); v < hole.patch.positions.size(); ++v)
    hole.patch.positions[v] = {0.0, 0.0, 1.0};
  relaxPatch(hole.model, {}, {}, hole.patch);
  for (const Position& position : hole.patch.positions)
    EXPECT_TRUE(position.allFinite());
}

} // namespace
} // namespace pcl::repair::test
