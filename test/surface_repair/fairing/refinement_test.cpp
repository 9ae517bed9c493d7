// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the refinement of patches.
#include <gtest/gtest.h>

#include "fairing/refinement.h"
#include "fairing_samples.h"
#include "icadm/model_assembly.h"
#include "mesh/corners.h"

#include <cmath>

namespace pcl::repair::test {
namespace {

double
meanEdge(const Patch& patch)
{
  return ccaa::meanEdge(patch.triangles, patch.triangles.size(), patch.positions);
}

TEST(RefinePatch, LeavesASoundDisc)
{
  for (const double angle : {0.2, 0.7, 1.5}) {
    PatchedHole hole = cappedSphere(4, angle);
    refinePatch(hole.model, {}, hole.patch);
    EXPECT_TRUE(isSound(hole)) << angle;
    EXPECT_EQ(eulerCharacteristic(hole.patch), 1) << angle;
  }
}

TEST(RefinePatch, KeepsWhatWasThere)
{
  PatchedHole hole = cappedSphere(4, 0.7);
  const Patch before = hole.patch;
  refinePatch(hole.model, {}, hole.patch);
  ASSERT_GT(hole.patch.positions.size(), before.positions.size());
  EXPECT_EQ(hole.patch.rim, before.rim);
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    EXPECT_EQ(hole.patch.positions[v], before.positions[v]);
  EXPECT_EQ(hole.patch.free_point.size(), hole.patch.positions.size());
  EXPECT_EQ(hole.patch.hole.size(), hole.patch.triangles.size());
}

TEST(RefinePatch, MakesEdgesAsLongAsThoseAround)
{
  PatchedHole hole = holedPlane(20, 14.0);
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_NEAR(meanEdge(hole.patch), 1.1, 0.15);
}

TEST(RefinePatch, TakesALengthOnRequest)
{
  PatchedHole hole = holedPlane(20, 14.0);
  RefinementParameters parameters;
  parameters.edge_length = 2.0;
  refinePatch(hole.model, parameters, hole.patch);
  EXPECT_NEAR(meanEdge(hole.patch), 2.1, 0.4);
}

TEST(RefinePatch, EndsAtTheGreatestNumber)
{
  PatchedHole hole = cappedSphere(4, 1.2);
  const std::size_t before = hole.patch.positions.size();
  RefinementParameters parameters;
  parameters.greatest_number = 37;
  refinePatch(hole.model, parameters, hole.patch);
  EXPECT_EQ(hole.patch.positions.size(), before + 37);
  EXPECT_TRUE(isSound(hole));
}

TEST(RefinePatch, StaysInThePlane)
{
  PatchedHole hole = holedPlane(12, 8.0);
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_EQ(largestOf(hole.patch, [](const Position& p) { return std::abs(p.z()); }),
            0.0);
}

TEST(RefinePatch, LeavesNoEdgeThatTheModelHas)
{
  // A cushion: two triangles above, two below, with the same diagonal.
  PatchedHole hole;
  const Positions corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  hole.model = assembleModel({{0, 1, 2}, {0, 2, 3}}, corners, {});
  hole.patch.rim = {0, 1, 2, 3};
  hole.patch.positions = corners;
  hole.patch.triangles = {{0, 2, 1}, {0, 3, 2}};
  hole.patch.free_point.assign(4, NONE);
  hole.patch.hole.assign(2, 0);
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_TRUE(isSound(hole));
  EXPECT_EQ(hole.patch.positions.size(), 5u);
}

TEST(RefinePatch, FollowsADensityThatVariesTwentyFold)
{
  ccaa::test::Shape plane = ccaa::test::grid(81, 81);
  const auto graded = [](double x) { return std::exp(std::log(20.0) * x / 80.0); };
  for (Position& p : plane.vertices)
    p = {graded(p.x()), graded(p.x()) * (p.y() - 40.0) / 26.7, 0.0};
  PatchedHole hole = withFan(
      plane, [](const Position& p) { return std::hypot(p.x() - 8, p.y()) < 5; });
  refinePatch(hole.model, {}, hole.patch);
  EXPECT_TRUE(isSound(hole));
  EXPECT_LT(hole.patch.positions.size(), 2 * hole.lost.size());
  EXPECT_GT(2 * hole.patch.positions.size(), hole.lost.size());
}

/** A strip whose long sides are single edges: vertices within it shorten no edge. */
TEST(RefinePatch, AddsFewVerticesBetweenLongBorders)
{
  PatchedHole hole;
  Positions points = {{0, 0, 0}, {40, 0, 0}, {40, 1, 0}, {0, 1, 0}};
  Triangles triangles;
  for (const auto& [a, b] :
       {std::pair(0, 1), std::pair(1, 2), std::pair(2, 3), std::pair(3, 0)}) {
    const Position middle = 0.5 * (points[static_cast<std::size_t>(a)] +
                                   points[static_cast<std::size_t>(b)]);
    const Position out = (middle - Position(20, 0.5, 0)).normalized();
    triangles.push_back({a, b, static_cast<pcl::index_t>(points.size())});
    std::swap(triangles.back()[0], triangles.back()[1]);
    points.push_back(middle + out);
  }
  hole.model = assembleModel(triangles, points, {});
  hole.patch.rim = {0, 1, 2, 3};
  hole.patch.positions = {points[0], points[1], points[2], points[3]};
  hole.patch.triangles = {{0, 1, 2}, {0, 2, 3}};
  hole.patch.free_point.assign(4, NONE);
  hole.patch.hole.assign(2, 0);
  RefinementParameters parameters;
  parameters.edge_length = 0.05;
  refinePatch(hole.model, parameters, hole.patch);
  EXPECT_TRUE(isSound(hole));
  EXPECT_LT(hole.patch.positions.size(), 10U);
}

TEST(RefinePatch, GivesTheSameOnceMore)
{
  PatchedHole one = cappedSphere(4, 0.9), other = one;
  refinePatch(one.model, {}, one.patch);
  refinePatch(other.model, {}, other.patch);
  EXPECT_EQ(one.patch.positions, other.patch.positions);
  EXPECT_EQ(one.patch.triangles, other.patch.triangles);
}

TEST(RefinePatch, LeavesAnEmptyPatchAlone)
{
  Patch patch;
  refinePatch(cappedSphere(2, 0.7).model, {}, patch);
  EXPECT_TRUE(patch.positions.empty());
}

} // namespace
} // namespace pcl::repair::test
