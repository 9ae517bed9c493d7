// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the evidence for a curve without a model.

#include <gtest/gtest.h>

#include "boundary/loop_evidence.h"
#include "surface_repair/boundary/boundary_models.h"
#include "surface_repair/force_line/sphere_rims.h"

#include <cmath>

namespace pcl::repair {
namespace {

using test::pinchedSphere;
using test::readingOf;
using test::sphereRim;

/** A circle of radius 1 in the plane, the surface beyond it or within it. */
BoundaryCurve
flatCircle(bool is_hole, std::size_t count = 60)
{
  BoundaryCurve curve;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = (is_hole ? -2.0 : 2.0) * M_PI * static_cast<double>(k) /
                         static_cast<double>(count);
    curve.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  curve.normals.assign(count, Direction::UnitZ());
  return curve;
}

BoundaryCurve
scaled(BoundaryCurve curve, double factor)
{
  for (Position& point : curve.points)
    point *= factor;
  return curve;
}

TEST(TurningOfACurve, OfAFlatHoleIsOne)
{
  EXPECT_NEAR(1.0, turningOf(flatCircle(true)), 1e-12);
}

TEST(TurningOfACurve, OfAFlatRimIsMinusOne)
{
  EXPECT_NEAR(-1.0, turningOf(flatCircle(false)), 1e-12);
}

TEST(TurningOfACurve, OfAFlatStarIsThatOfACircle)
{
  BoundaryCurve star = flatCircle(true);
  for (std::size_t k = 0; k < star.size(); k += 2)
    star.points[k] *= 0.6;
  EXPECT_NEAR(1.0, turningOf(star), 1e-12);
}

TEST(TurningOfACurve, DoesNotDependOnScale)
{
  const BoundaryCurve rim = sphereRim(0.4, true, 40);
  for (const double factor : {1e-9, 1e9})
    EXPECT_NEAR(turningOf(rim), turningOf(scaled(rim, factor)), 1e-9);
}

/** On the unit sphere, of which a cap is there, it is minus the height of its rim. */
TEST(TurningOfACurve, OfACapIsTheHeightOfItsRim)
{
  for (const double z : {-0.8, -0.3, 0.0, 0.3, 0.8})
    EXPECT_NEAR(-z, turningOf(sphereRim(z, true, 400)), 1e-3) << z;
}

TEST(TurningOfACurve, OfTheSameCurveAroundTheOtherSideIsTheOpposite)
{
  EXPECT_NEAR(-turningOf(sphereRim(0.4, true, 50)),
              turningOf(sphereRim(0.4, false, 50)),
              1e-12);
}

/** Gauss and Bonnet: what the angles of the triangles say, the curve says, too. */
TEST(TurningOfACurve, IsThatOfTheModelOnAFlatSheet)
{
  const IncompleteModel model =
      test::modelOf(test::without(ccaa::test::grid(21, 21), [](const Position& p) {
        return std::hypot(p.x() - 10.0, p.y() - 10.0) < 5.0;
      }));
  for (const BoundaryLoop& loop : extractBoundaries(model))
    EXPECT_NEAR(turningOf(model, loop), turningOf(loop.curve), 1e-9);
}

TEST(EvidenceOfACurve, SpeaksForAHoleInALargeSheet)
{
  const LoopEvidence evidence = evidenceOf(flatCircle(true), 1000.0);
  EXPECT_NEAR(1.0, evidence.integral.relative(), 1e-6);
  EXPECT_NEAR(1.0, evidence.turning, 1e-12);
  EXPECT_GT(evidence.score(), 3.0);
}

TEST(EvidenceOfACurve, OfAFlatDiscIsTheClearestRim)
{
  const double area = 30.0 * std::sin(2.0 * M_PI / 60.0);
  EXPECT_NEAR(-4.0, evidenceOf(flatCircle(false), area).score(), 0.01);
}

TEST(EvidenceOfACurve, ADiscClosesItsAreaOnce)
{
  const double area = 30.0 * std::sin(2.0 * M_PI / 60.0);
  EXPECT_NEAR(1.0, evidenceOf(flatCircle(false), area).area_ratio, 1e-9);
}

TEST(EvidenceOfACurve, HalfASphereIsNeitherHoleNorRim)
{
  EXPECT_NEAR(0.0, evidenceOf(sphereRim(0.0, true, 200), 2.0 * M_PI).score(), 0.02);
}

TEST(EvidenceOfACurve, MoreAreaSpeaksForAHole)
{
  const BoundaryCurve curve = sphereRim(0.0, true, 100);
  double before = evidenceOf(curve, 1.0).score();
  for (const double area : {2.0, 5.0, 8.0, 20.0, 100.0}) {
    const double score = evidenceOf(curve, area).score();
    EXPECT_GE(score, before) << area;
    before = score;
  }
}

TEST(EvidenceOfACurve, DoesNotDependOnScale)
{
  const BoundaryCurve rim = sphereRim(0.4, true, 40);
  for (const double factor : {1e-6, 1e6})
    EXPECT_NEAR(evidenceOf(rim, 2.0).score(),
                evidenceOf(scaled(rim, factor), 2.0 * factor * factor).score(),
                1e-6);
}

TEST(EvidenceOfACurve, KnowsNothingOfOtherLoops)
{
  const LoopEvidence evidence = evidenceOf(flatCircle(true), 10.0);
  EXPECT_FALSE(evidence.is_tube_mouth);
  EXPECT_FALSE(evidence.within_rim);
}

TEST(Turning, OfAHoleDoesNotChangeWhereAnotherOneMeetsIt)
{
  const IncompleteModel alone = readingOf(pinchedSphere(1));
  const double expected = turningOf(alone, extractBoundaries(alone)[0]);
  for (const std::size_t holes : {2U, 3U}) {
    const IncompleteModel model = readingOf(pinchedSphere(holes));
    for (const BoundaryLoop& loop : extractBoundaries(model))
      EXPECT_NEAR(expected, turningOf(model, loop), 0.02);
  }
}

} // namespace
} // namespace pcl::repair
