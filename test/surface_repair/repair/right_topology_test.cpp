// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of whether damaged bodies come out with the topology
// that they had, or are told to be incomplete.

#include <gtest/gtest.h>

#include "support/random_source.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::repair::test {
namespace {

/** Between the halves a strip of triangles is lost, whose tips they have in common. */
TEST(RightTopology, IslandsThatTouchInPointsAreJoinedThere)
{
  for (const double height : {0.0, 0.1, 0.3, 0.5}) {
    SCOPED_TRACE(height);
    const Repaired result = repaired(without(icosphere(3), [height](const Position& p) {
      return std::abs(p.z() - height) < 0.055;
    }));
    EXPECT_EQ(2U, result.report.islands.size());
    EXPECT_GT(result.report.reading.separated_fans, 3U);
    expectWhole(result, 1, 2);
  }
}

TEST(RightTopology, StumpsOfALimbAreJoinedAndNotCapped)
{
  for (const double gap : {0.2, 0.5, 0.9}) {
    SCOPED_TRACE(gap);
    expectWhole(repaired(without(ellipsoid(4, 4.0),
                                 [gap](const Position& p) {
                                   return std::abs(p.z() - 1.5) < 0.5 * gap;
                                 })),
                1,
                2);
  }
}

/** A bent limb. \param[in] is_lost of the straight one */
Shape
bentLimb(double length,
         double bend,
         const std::function<bool(const Position&)>& is_lost)
{
  Shape limb = without(ellipsoid(3, length), is_lost);
  for (Position& p : limb.vertices)
    p.x() += bend * p.z() * p.z();
  return withoutFreeVertices(limb);
}

/** A bent limb of which a slanting slice is lost. */
Shape
cutLimb(std::uint64_t seed)
{
  RandomSource random(seed);
  const double length = random.uniform(3.0, 10.0);
  const double bend = random.uniform(0.0, 0.6) / length;
  const double tilt = random.uniform(0.0, 1.5);
  const double gap = random.uniform(0.5, 2.5);
  const double height = length * random.uniform(0.2, 0.6);
  return bentLimb(length, bend, [=](const Position& p) {
    return std::abs(p.z() - height + tilt * p.x()) < 0.5 * gap;
  });
}

/** A bent limb of which a long slanting slice is lost, and a place beside its end. */
Shape
cutLimbWithHole(std::uint64_t seed)
{
  RandomSource random(seed);
  const double length = random.uniform(4.0, 10.0);
  const double bend = random.uniform(0.0, 1.0) / length;
  const double tilt = random.uniform(0.0, 1.5);
  const double gap = random.uniform(2.0, 6.0);
  const double height = length * random.uniform(-0.2, 0.4);
  const double hole = length * random.uniform(0.7, 0.95);
  return bentLimb(length, bend, [=](const Position& p) {
    return std::abs(p.z() - height + tilt * p.x()) < 0.5 * gap ||
           (std::abs(p.z() + hole) < 0.05 * length && p.y() > 0.0);
  });
}

/** Each hole that bridges leave there would run into another one. */
TEST(RightTopology, LimbsAreJoinedAllAroundWherePartsOfTheGapCannotBeFilled)
{
  for (const std::uint64_t seed : {121, 504, 706, 1214}) {
    SCOPED_TRACE(seed);
    const Repaired result = repaired(cutLimb(seed));
    expectNothingLost(result);
    EXPECT_EQ(1U, topologyOf(result.triangles()).components);
    EXPECT_EQ(0U, topologyOf(result.triangles()).borders);
  }
}

/** The first pass fails there and closes the hole; the next one finds less evidence. */
TEST(RightTopology, LimbsThatFailedAreJoinedBeforeAnotherPassPartsThem)
{
  for (const std::uint64_t seed : {308, 311, 312, 321, 322, 337}) {
    SCOPED_TRACE(seed);
    const Repaired result = repaired(cutLimbWithHole(seed));
    expectOnePiece(result, 2);
  }
}

/** A limb of which the middle is lost, over so much of its axis. */
Shape
gappedLimb(double gap)
{
  return withoutFreeVertices(without(ellipsoid(4, 4.0), [gap](const Position& p) {
    return std::abs(p.z() - 1.0) < 0.5 * gap;
  }));
}

/** Too long to be sure, and there is nothing else. */
TEST(RightTopology, LoneStumpsAreJoinedOverALongGapAndThatIsTold)
{
  for (const double gap : {5.0, 5.5}) {
    SCOPED_TRACE(gap);
    const Repaired result = repaired(gappedLimb(gap));
    expectOnePiece(result, 2);
    ASSERT_FALSE(result.report.complete());
    EXPECT_EQ(DoubtReason::LONG_GAP, result.report.doubts.front().reason);
  }
}

TEST(RightTopology, ADecisionToJoinLoneStumpsSettlesTheDoubt)
{
  const Shape limb = gappedLimb(5.0);
  Decisions decisions = proposed(limb);
  ASSERT_EQ(1U, decisions.junctions.size());
  decisions.junctions.front().join = true;
  for (const RepairDoubt& doubt : decided(limb, decisions).report.doubts)
    EXPECT_NE(DoubtReason::LONG_GAP, doubt.reason);
}

/** Two bodies side by side, each without one end. */
TEST(RightTopology, StumpsThatDoNotFaceEachOtherStayOpenAndAreTold)
{
  const auto stump = [](double x) {
    return translated(
        without(ellipsoid(4, 4.0), [](const Position& p) { return p.z() > 2.0; }),
        Position(x, 0.0, 0.0));
  };
  const Repaired result = repaired(joined(stump(0.0), stump(5.0)));
  expectNothingLost(result);
  EXPECT_EQ(2U, topologyOf(result.triangles()).borders);
  EXPECT_FALSE(result.report.complete());
}

/** A limb that lacks its middle and its end. */
TEST(RightTopology, AnOpenEndOfATubeThatGoesOnIsTold)
{
  const Shape limb =
      withoutFreeVertices(without(ellipsoid(5, 4.0), [](const Position& p) {
        return std::abs(p.z() - 0.5) < 0.3 || p.z() > 2.4;
      }));
  const Repaired result = repaired(limb);
  expectNothingLost(result);
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  EXPECT_TRUE(topologyOf(result.triangles()).borders == 0 || !result.report.complete());
}

/** Beside a body with a hole elsewhere. */
TEST(RightTopology, TipsSideBySideDoNotBecomeABodyOfTheirOwn)
{
  const auto tip = [](double x) {
    return translated(
        without(ellipsoid(4, 4.0), [](const Position& p) { return p.z() < 0.4; }),
        Position(x, 0.0, 6.0));
  };
  const Shape body =
      without(ellipsoid(5, 4.0), [](const Position& p) { return p.z() > 2.0; });
  const Repaired result = repaired(joined(body, joined(tip(-1.2), tip(1.2))));
  expectNothingLost(result);
  for (const RepairJunction& junction : result.report.junctions)
    EXPECT_TRUE(junction.verdict != JunctionVerdict::JOINED ||
                junction.islands[0] == 0 || junction.islands[1] == 0);
  EXPECT_FALSE(result.report.complete());
}

TEST(RightTopology, AHoleBesideAnotherBodyIsCapped)
{
  const Shape with_hole =
      without(icosphere(4), [](const Position& p) { return p.z() > 0.9; });
  expectWhole(
      repaired(joined(with_hole, translated(icosphere(4), Position(3.0, 0.0, 0.0)))),
      2,
      4);
}

/** A ball with two to four fingers side by side, all cut off by a slanting slice. */
Shape
cutFingers(std::uint64_t seed)
{
  RandomSource random(seed);
  const std::size_t fingers = 2 + random.below(3);
  const double apart = random.uniform(0.28, 0.4);
  const double width = random.uniform(0.13, 0.16);
  const double height = random.uniform(1.0, 2.0);
  const double from = 1.0 + height * random.uniform(0.15, 0.3);
  const double gap = height * random.uniform(0.2, 0.5);
  const double tilt = random.uniform(-0.8, 0.8);
  Shape hand = icosphere(4);
  for (Position& p : hand.vertices) {
    double radius = 1.0;
    for (std::size_t i = 0; i < fingers; ++i) {
      const double turn =
          apart * (static_cast<double>(i) - 0.5 * static_cast<double>(fingers - 1));
      const double cosine = p.dot(Position(std::sin(turn), 0.0, std::cos(turn)));
      const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / width;
      radius = std::max(radius, 1.0 + height * std::exp(-std::pow(angle, 4.0)));
    }
    p *= radius;
  }
  return withoutFreeVertices(without(hand, [=](const Position& p) {
    const double distance = p.norm() - tilt * p.x();
    return distance > from && distance < from + gap;
  }));
}

/** Some have a single bridge, others twisted ones, and neighbours are nearer to each
 * other than to the stumps that they were cut off. */
TEST(RightTopology, FingersCutOffTogetherComeBackEachByItself)
{
  constexpr std::size_t SEEDS = 40;
  std::size_t right = 0;
  for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
    SCOPED_TRACE(seed);
    const Repaired result = repaired(cutFingers(seed));
    expectNothingLost(result);
    const Topology after = topologyOf(result.triangles());
    const bool is_right =
        after.components == 1 && after.borders == 0 && after.characteristic == 2;
    right += is_right ? 1 : 0;
    EXPECT_TRUE(is_right || !result.report.complete());
  }
  EXPECT_GE(right, SEEDS * 95 / 100);
}

TEST(RightTopology, AHandleThatWasCutThroughComesBack)
{
  for (const int cuts : {2, 3, 4}) {
    SCOPED_TRACE(cuts);
    const double period = 2.0 * M_PI / cuts;
    expectWhole(repaired(without(torus(96, 40),
                                 [period](const Position& p) {
                                   const double angle = std::atan2(p.y(), p.x());
                                   return std::abs(std::remainder(angle, period)) < 0.1;
                                 })),
                1,
                0);
  }
}

/** Balls and slabs taken away from a shape with its middle at the origin. */
Shape
damaged(const Shape& shape, std::uint64_t seed)
{
  RandomSource random(seed);
  const auto direction = [&] {
    return Position(random.normal(), random.normal(), random.normal()).normalized();
  };
  std::vector<std::pair<Position, double>> slabs;
  for (std::size_t i = random.below(3); i > 0; --i)
    slabs.emplace_back(direction(), random.uniform(-0.6, 0.6));
  std::vector<Position> balls;
  for (std::size_t i = 1 + random.below(3); i > 0; --i)
    balls.push_back(shape.vertices[random.below(shape.vertices.size())]);
  const double width = random.uniform(0.06, 0.15);
  const double radius = random.uniform(0.15, 0.3);
  return without(shape, [&](const Position& p) {
    for (const auto& [normal, shift] : slabs)
      if (std::abs(p.dot(normal) - shift) < 0.5 * width)
        return true;
    for (const Position& ball : balls)
      if ((p - ball).norm() < radius)
        return true;
    return false;
  });
}

/** The junctions bend too much to be sure, but a mouth goes on somewhere. */
TEST(RightTopology, NoMouthIsCappedToGiveUpAHandle)
{
  for (const std::uint64_t seed : {5, 67, 115}) {
    SCOPED_TRACE(seed);
    const Repaired result =
        repaired(withoutFreeVertices(damaged(torus(80, 20, 1.0, 0.22), seed)));
    expectOnePiece(result, 0);
  }
}

/** The mouths of a tube stay open, and are reported so. */
bool
isTube(const Repaired& result)
{
  const auto& holes = result.report.holes;
  return result.report.islands.size() == 1 &&
         std::any_of(holes.begin(), holes.end(), [](const RepairedHole& hole) {
           return hole.open == OpenReason::TUBE_MOUTH;
         });
}

/** Whatever comes out: right, or told to be incomplete; most of it right. */
TEST(RightTopology, NoDamageIsRepairedWronglyInSilence)
{
  const std::vector<std::pair<Shape, long>> bodies = {
      {icosphere(3), 2}, {ellipsoid(3, 2.5), 2}, {torus(48, 20), 0}};
  constexpr std::uint64_t SEEDS = 70;
  std::size_t right = 0;
  for (std::size_t body = 0; body < bodies.size(); ++body)
    for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
      SCOPED_TRACE(testing::Message() << "body " << body << ", seed " << seed);
      const Repaired result =
          repaired(withoutFreeVertices(damaged(bodies[body].first, seed)));
      expectNothingLost(result);
      const Topology after = topologyOf(result.triangles());
      const bool is_right = after.components == 1 && after.borders == 0 &&
                            after.characteristic == bodies[body].second;
      right += is_right ? 1 : 0;
      EXPECT_TRUE(is_right || !result.report.complete() || isTube(result));
    }
  EXPECT_GE(right, bodies.size() * SEEDS * 95 / 100);
}

} // namespace
} // namespace pcl::repair::test
