// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of tracing force lines.

#include <gtest/gtest.h>

#include "field/shielding.h"
#include "sphere_rims.h"

#include <cmath>

namespace pcl::repair {
namespace {

using test::Islands;
using test::sphereRim;
using test::TWO_PI;

constexpr double HALF_GAP = 0.35;

std::vector<BoundaryCurve>
twoCaps(std::size_t count = 60, double half_gap = HALF_GAP)
{
  return {sphereRim(half_gap, true, count, 0.3),
          sphereRim(-half_gap, false, count + 7)};
}

std::vector<ForceLine>
trace(const Islands& islands,
      std::size_t from,
      const TrackerParameters& parameters = {},
      const Shield* obstacle = nullptr,
      int threads = 1)
{
  const ForceLineTracker tracker(islands.field, islands.targets, parameters, obstacle);
  ccaa::LoopContext context;
  context.threads = threads;
  return tracker.track(islands.originsOn(from), context);
}

double
angleOf(const Position& position)
{
  return std::atan2(position.y(), position.x());
}

/** Sideways drift along the rim, relative to the gap. */
double
driftOf(const ForceLine& line, double half_gap)
{
  const double turn = std::remainder(
      angleOf(line.target.position) - angleOf(line.points.front()), TWO_PI);
  return std::abs(turn) * std::sqrt(1.0 - half_gap * half_gap) / (2.0 * half_gap);
}

struct CapCase {
  std::size_t sources;
  double half_gap;
};

class TwoCaps : public ::testing::TestWithParam<CapCase> {};

TEST_P(TwoCaps, EveryLineReachesTheOtherCap)
{
  const Islands islands(twoCaps(GetParam().sources, GetParam().half_gap));
  for (const ForceLine& line : trace(islands, 1)) {
    EXPECT_EQ(LineEnd::BRIDGE, line.end) << describe(line.end);
    EXPECT_EQ(0U, line.target.curve);
  }
}

TEST_P(TwoCaps, LinesDriftLessThanHalfAPercentOfTheGap)
{
  const Islands islands(twoCaps(GetParam().sources, GetParam().half_gap));
  for (const ForceLine& line : trace(islands, 1))
    EXPECT_LT(driftOf(line, GetParam().half_gap), 0.005);
}

std::string
nameOf(const ::testing::TestParamInfo<CapCase>& tested)
{
  return std::to_string(tested.param.sources) + "SourcesHalfGap" +
         std::to_string(static_cast<int>(100.0 * tested.param.half_gap));
}

INSTANTIATE_TEST_SUITE_P(SourcesAndGaps,
                         TwoCaps,
                         ::testing::Values(CapCase{60, 0.35},
                                           CapCase{120, 0.1},
                                           CapCase{120, 0.35},
                                           CapCase{400, 0.35},
                                           CapCase{120, 0.7}),
                         nameOf);

TEST(ForceLineTracker, LineBetweenCapsRunsBetweenChordAndSphere)
{
  const ForceLine line = trace(Islands(twoCaps()), 1)[5];
  const Position middle =
      resampled(line, 0.01)
          .points[static_cast<std::size_t>(std::round(0.5 * line.length / 0.01))];
  EXPECT_GT(middle.norm(), 0.88);
  EXPECT_LT(middle.norm(), 1.0);
}

TEST(ForceLineTracker, NormalsPointOutOfTheSphereAllAlong)
{
  for (const ForceLine& line : trace(Islands(twoCaps()), 1))
    for (std::size_t k = 0; k < line.points.size(); ++k)
      EXPECT_GT(line.normals[k].dot(line.points[k].normalized()), 0.8);
}

TEST(ForceLineTracker, NormalAtAJaggedTargetIsThatOfTheBoundaryAsAWhole)
{
  std::vector<BoundaryCurve> caps = twoCaps(120);
  for (std::size_t k = 0; k < caps[0].size(); k += 2)
    caps[0].points[k].head<2>() *= 0.95; // as far as the points are apart
  for (const ForceLine& line : trace(Islands(caps), 1)) {
    ASSERT_EQ(LineEnd::BRIDGE, line.end) << describe(line.end);
    EXPECT_GT(line.normals.back().dot(line.points.back().normalized()), 0.7);
  }
}

TEST(ForceLineTracker, LineEndsOnTheEdgeItNames)
{
  const Islands islands(twoCaps());
  const ForceLine line = trace(islands, 1)[0];
  const BoundaryCurve& rim = islands.targets.curves()[0].curve;
  const Position expected =
      rim.points[line.target.edge] + line.target.share * rim.edge(line.target.edge);
  EXPECT_LT((line.points.back() - expected).norm(), 1e-14);
}

TEST(ForceLineTracker, LineBeginsAtItsOrigin)
{
  const Islands islands(twoCaps());
  EXPECT_EQ(islands.originsOn(1)[3].point.position,
            trace(islands, 1)[3].points.front());
}

TEST(ForceLineTracker, QualityIsTheMeanTensionAlongTheLine)
{
  const ForceLine line = trace(Islands(twoCaps()), 1)[0];
  double sum = 0.0;
  for (std::size_t k = 1; k < line.points.size(); ++k)
    sum += 0.5 * (line.tensions[k - 1] + line.tensions[k]) *
           (line.points[k] - line.points[k - 1]).norm();
  EXPECT_NEAR(sum / line.length, line.quality, 1e-12);
}

TEST(ForceLineTracker, FlippedIslandIsRepelled)
{
  std::vector<BoundaryCurve> caps = twoCaps();
  caps[1] = test::turned(caps[1]);
  for (const ForceLine& line : trace(Islands(caps), 1))
    EXPECT_EQ(LineEnd::REPELLED, line.end) << describe(line.end);
}

TEST(ForceLineTracker, OriginThatNothingReachesHasNoField)
{
  const Islands islands(twoCaps());
  LineOrigin origin = islands.originsOn(1)[0];
  origin.query.falloff.far = 0.5; // the gap is 0.7
  const ForceLineTracker tracker(islands.field, islands.targets, {});
  EXPECT_EQ(LineEnd::NO_FIELD, tracker.track(origin).end);
}

TEST(ForceLineTracker, LineLongerThanAllowedIsGivenUp)
{
  TrackerParameters parameters;
  parameters.greatest_length = 0.1;
  EXPECT_EQ(LineEnd::TOO_LONG, trace(Islands(twoCaps()), 1, parameters)[0].end);
}

TEST(ForceLineTracker, LineThroughTheSurfaceIsGivenUp)
{
  IncompleteModel wall;
  wall.positions = {{-9, -9, 0}, {9, -9, 0}, {0, 18, 0}};
  wall.triangles = {{0, 1, 2}};
  const Shield shield(wall);
  for (const ForceLine& line : trace(Islands(twoCaps()), 1, {}, &shield))
    EXPECT_EQ(LineEnd::CROSSES_SURFACE, line.end) << describe(line.end);
}

TEST(ForceLineTracker, LinesAreTheSameForAnyNumberOfThreads)
{
  const Islands islands(twoCaps());
  const std::vector<ForceLine> one = trace(islands, 1);
  const std::vector<ForceLine> seven = trace(islands, 1, {}, nullptr, 7);
  ASSERT_EQ(one.size(), seven.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].points, seven[i].points);
}

TEST(ForceLineTracker, SmallerToleranceMovesTheLineLittle)
{
  const Islands islands(twoCaps(400));
  TrackerParameters strict;
  strict.tolerance = 1e-4;
  const Position loose_end = trace(islands, 1)[0].points.back();
  const Position strict_end = trace(islands, 1, strict)[0].points.back();
  EXPECT_LT((loose_end - strict_end).norm(), 1e-3);
}

/** Moved, turned and scaled curves. */
std::vector<BoundaryCurve>
moved(std::vector<BoundaryCurve> curves, const Eigen::Matrix3d& turn, double scale)
{
  for (BoundaryCurve& curve : curves) {
    for (Position& point : curve.points)
      point = scale * (turn * point + Position(3.0, -2.0, 1.0));
    for (Direction& normal : curve.normals)
      normal = turn * normal;
  }
  return curves;
}

TEST(ForceLineTracker, MovingTurningAndScalingChangesNothingButTheFrame)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Direction(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const double scale = 250.0;
  const std::vector<BoundaryCurve> caps = twoCaps();
  const ForceLine line = trace(Islands(caps), 1)[2];
  const ForceLine other = trace(Islands(moved(caps, turn, scale)), 1)[2];
  ASSERT_EQ(line.points.size(), other.points.size());
  for (std::size_t k = 0; k < line.points.size(); ++k) {
    const Position expected =
        scale * (turn * line.points[k] + Position(3.0, -2.0, 1.0));
    EXPECT_LT((expected - other.points[k]).norm(), 1e-6 * scale);
  }
}

/** The rim of a hole in a flat plate, an ellipse. */
BoundaryCurve
flatHole(std::size_t count)
{
  BoundaryCurve hole;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = -TWO_PI * static_cast<double>(k) / static_cast<double>(count);
    hole.points.emplace_back(3.0 * std::cos(angle), std::sin(angle), 0.0);
    hole.normals.push_back(Direction::UnitZ());
  }
  return hole;
}

TEST(ForceLineTracker, LineInAHoleEndsBeyondTheThreshold)
{
  const Islands plate({flatHole(80)});
  const double threshold = 0.25 * plate.targets.lengthOf(0);
  const auto origins = originsInHole(
      plate.field, plate.targets, 0, threshold, Reach(), ccaa::LoopContext());
  const ForceLineTracker tracker(plate.field, plate.targets, {});
  ASSERT_FALSE(origins.empty());
  for (const std::size_t i : strongestOrigins(origins, plate.targets, 1.0)) {
    const ForceLine line = tracker.track(origins[i].origin);
    ASSERT_EQ(LineEnd::BRIDGE, line.end) << describe(line.end);
    EXPECT_GT(plate.targets.arcBetween(0,
                                       plate.targets.arcAt(line.origin),
                                       plate.targets.arcAt(line.target)),
              0.9 * threshold);
  }
}

TEST(ForceLineTracker, LineInAFlatHoleStaysInItsPlane)
{
  const Islands plate({flatHole(80)});
  const auto origins =
      originsInHole(plate.field, plate.targets, 0, 2.0, Reach(), ccaa::LoopContext());
  const ForceLineTracker tracker(plate.field, plate.targets, {});
  const ForceLine line =
      tracker.track(origins[strongestOrigins(origins, plate.targets, 1.0)[0]].origin);
  for (const Position& point : line.points)
    EXPECT_NEAR(0.0, point.z(), 1e-12);
}

TEST(ResampledLine, PointsAreAboutAtTheSpacing)
{
  const ForceLine line = resampled(trace(Islands(twoCaps()), 1)[0], 0.05);
  for (std::size_t k = 1; k < line.points.size(); ++k)
    EXPECT_NEAR(0.05, (line.points[k] - line.points[k - 1]).norm(), 0.01);
}

TEST(ResampledLine, EndsKeepTheirBits)
{
  const ForceLine line = trace(Islands(twoCaps()), 1)[0];
  const ForceLine even = resampled(line, 0.05);
  EXPECT_EQ(line.points.front(), even.points.front());
  EXPECT_EQ(line.points.back(), even.points.back());
}

TEST(ResampledLine, InnerNormalsAreUnitVectorsAcrossTheLine)
{
  const ForceLine line = resampled(trace(Islands(twoCaps()), 1)[0], 0.02);
  for (std::size_t k = 1; k + 1 < line.points.size(); ++k) {
    EXPECT_NEAR(1.0, line.normals[k].norm(), 1e-12);
    EXPECT_NEAR(
        0.0, line.normals[k].dot(line.points[k + 1] - line.points[k - 1]), 1e-12);
  }
}

} // namespace
} // namespace pcl::repair
