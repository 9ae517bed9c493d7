// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the boundary edges at which a force line can end.

#include <gtest/gtest.h>

#include "sphere_rims.h"

#include <cmath>
#include <random>

namespace pcl::repair {
namespace {

using test::sphereRim;

BoundaryEdges
twoRims()
{
  return BoundaryEdges(
      {{sphereRim(0.35, true, 30), 0}, {sphereRim(-0.35, false, 37), 1}});
}

/** Distance from a segment to all edges by fine sampling of both. */
double
sampledDistance(const BoundaryEdges& edges, const Position& a, const Position& b)
{
  double least = 1e9;
  for (const TargetCurve& target : edges.curves())
    for (std::size_t k = 0; k < target.curve.size(); ++k)
      for (int i = 0; i <= 100; ++i)
        for (int j = 0; j <= 20; ++j) {
          const Position on_edge =
              target.curve.points[k] + 0.05 * j * target.curve.edge(k);
          least = std::min(least, (a + 0.01 * i * (b - a) - on_edge).norm());
        }
  return least;
}

TEST(BoundaryEdges, FindsTheClosestEncounterOfASegment)
{
  const BoundaryEdges edges = twoRims();
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  for (int trial = 0; trial < 8; ++trial) {
    const Position a(place(generator), place(generator), place(generator));
    const Position b(place(generator), place(generator), place(generator));
    const auto found = edges.closest(a, b, 5.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(sampledDistance(edges, a, b), found->distance, 0.02);
    EXPECT_LE(found->distance, sampledDistance(edges, a, b) + 1e-12);
  }
}

TEST(BoundaryEdges, EncounterLiesOnTheEdgeItNames)
{
  const BoundaryEdges edges = twoRims();
  const Position from(0.2, 0.1, 0.0);
  const auto found = edges.closest(from, Position(1.0, 0.3, 0.1), 5.0);
  ASSERT_TRUE(found);
  const BoundaryCurve& curve = edges.curves()[found->point.curve].curve;
  const Position expected = curve.points[found->point.edge] +
                            found->point.share * curve.edge(found->point.edge);
  EXPECT_LT((expected - found->point.position).norm(), 1e-14);
}

TEST(BoundaryEdges, NothingIsFoundBeyondTheDistance)
{
  const Position centre = Position::Zero();
  EXPECT_FALSE(twoRims().closest(centre, centre, 0.9));
}

TEST(BoundaryEdges, EdgesThatDoNotCountAreNotFound)
{
  const Position near_first(0.9, 0.0, 0.3);
  const auto found = twoRims().closest(
      near_first, near_first, 5.0, [](std::size_t curve) { return curve == 1; });
  ASSERT_TRUE(found);
  EXPECT_EQ(1U, found->point.curve);
}

TEST(BoundaryEdges, LowestEdgeOfEqualsIsTaken)
{
  const Position centre(0.0, 0.0, 0.35);
  const auto found =
      twoRims().closest(centre, centre, 5.0, {}, [](std::size_t c, std::size_t e) {
        return c == 0 && (e == 7 || e == 22); // opposite each other
      });
  ASSERT_TRUE(found);
  EXPECT_EQ(7U, found->point.edge);
}

TEST(BoundaryEdges, AGuessDoesNotChangeWhatIsFound)
{
  const BoundaryEdges edges = twoRims();
  const Position a(0.8, 0.1, 0.3), b(0.9, -0.4, 0.2);
  const auto expected = edges.closest(a, b, 0.5);
  ASSERT_TRUE(expected);
  for (std::size_t curve = 0; curve < 2; ++curve)
    for (std::size_t edge = 0; edge < edges.curves()[curve].curve.size(); ++edge) {
      const auto found = edges.closest(a, b, 0.5, {}, {}, {curve, edge});
      ASSERT_TRUE(found);
      EXPECT_EQ(expected->point.curve, found->point.curve);
      EXPECT_EQ(expected->point.edge, found->point.edge);
      EXPECT_EQ(expected->distance, found->distance);
    }
}

TEST(BoundaryEdges, AGuessBeyondTheDistanceIsNotFound)
{
  const Position centre = Position::Zero();
  EXPECT_FALSE(twoRims().closest(centre, centre, 0.9, {}, {}, {1, 5}));
}

TEST(BoundaryEdges, SegmentAlongAnEdgeTouchesIt)
{
  const BoundaryEdges edges = twoRims();
  const BoundaryCurve& curve = edges.curves()[0].curve;
  const auto found = edges.closest(
      curve.points[3] - curve.edge(3), curve.points[3] + 2.0 * curve.edge(3), 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(0.0, found->distance, 1e-14);
}

TEST(BoundaryEdges, ArcLeadsToThePointAndBack)
{
  const BoundaryEdges edges = twoRims();
  for (double share = 0.0; share < 1.0; share += 0.037) {
    const double arc = share * edges.lengthOf(1);
    EXPECT_NEAR(arc, edges.arcAt(edges.pointAt(1, arc)), 1e-12);
  }
}

TEST(BoundaryEdges, ArcBeyondTheEndGoesRoundAgain)
{
  const BoundaryEdges edges = twoRims();
  const double length = edges.lengthOf(0);
  EXPECT_LT((edges.pointAt(0, 0.3 * length).position -
             edges.pointAt(0, 1.3 * length).position)
                .norm(),
            1e-12);
}

TEST(BoundaryEdges, ArcBetweenGoesTheShorterWayRound)
{
  const BoundaryEdges edges = twoRims();
  const double length = edges.lengthOf(0);
  EXPECT_NEAR(0.2 * length, edges.arcBetween(0, 0.1 * length, 0.9 * length), 1e-12);
}

} // namespace
} // namespace pcl::repair
