// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of source sampling (4.46).
#include <gtest/gtest.h>

#include "field/source_sampling.h"
#include "field_samples.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::repair::test {
namespace {

TEST(SourceSampling, PutsSourcesAtEqualDistancesAlongTheCurve)
{
  const SourceCurve curve = sampleSources(ring(100, 2.0, 0.0, true), 0.3);
  EXPECT_NEAR(
      curve.spacing * static_cast<double>(curve.sources.size()), curve.length, 1e-12);
  for (std::size_t k = 0; k < curve.sources.size(); ++k)
    EXPECT_NEAR(curve.sources[k].arc, static_cast<double>(k) * curve.spacing, 1e-12);
}

TEST(SourceSampling, KeepsSourcesOnTheCurve)
{
  for (const FieldSource& source :
       sampleSources(ring(4, std::sqrt(0.5), 0.0, true), 0.01).sources)
    EXPECT_NEAR(source.position.cwiseAbs().sum(), std::sqrt(0.5), 1e-12);
}

TEST(SourceSampling, TakesTheMeanEdgeWithoutASpacing)
{
  EXPECT_EQ(sampleSources(ring(37, 1.0, 0.0, true)).sources.size(), 37u);
}

TEST(SourceSampling, MakesEightSourcesOfATriangle)
{
  EXPECT_EQ(sampleSources(ring(3, 1.0, 0.0, true)).sources.size(), 8u);
}

TEST(SourceSampling, GivesUnitTangentsAlongTheWalk)
{
  for (const FieldSource& source : sampleSources(ring(200, 1.0, 0.0, true)).sources) {
    const Direction expected = Position::UnitZ().cross(source.position).normalized();
    EXPECT_NEAR(source.tangent.dot(expected), 1.0, 1e-12);
  }
}

TEST(SourceSampling, GivesUnitNormalsAcrossTheTangent)
{
  BoundaryCurve curve = ring(50, 1.0, 0.0, true);
  for (Direction& normal : curve.normals)
    normal = (normal + Direction(0.3, 0.2, 0.4)).normalized();
  for (const FieldSource& source : sampleSources(curve).sources) {
    EXPECT_NEAR(source.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(source.normal.dot(source.tangent), 0.0, 1e-12);
  }
}

TEST(SourceSampling, SmoothsAJaggedCurve)
{
  BoundaryCurve curve = ring(400, 1.0, 0.0, true);
  for (std::size_t k = 0; k < curve.size(); k += 2)
    curve.points[k].z() += 0.01;
  for (const FieldSource& source : sampleSources(curve, 0.1).sources)
    EXPECT_LT(std::abs(source.tangent.z()), 0.11);
}

TEST(SourceSampling, SurvivesEdgesWithoutLengthAndNormal)
{
  BoundaryCurve curve = ring(10, 1.0, 0.0, true);
  curve.points[3] = curve.points[4];
  curve.normals.assign(10, Direction::Constant(std::nan("")));
  for (const FieldSource& source : sampleSources(curve).sources) {
    EXPECT_TRUE(source.tangent.allFinite());
    EXPECT_NEAR(source.normal.norm(), 1.0, 1e-12);
  }
}

TEST(SourceSampling, MakesNothingOfACurveWithoutLength)
{
  BoundaryCurve curve;
  curve.points.assign(5, Position(1, 2, 3));
  curve.normals.assign(5, Direction::UnitZ());
  EXPECT_TRUE(sampleSources(curve).sources.empty());
  EXPECT_TRUE(sampleSources(BoundaryCurve()).sources.empty());
}

TEST(SourceSampling, ChargesAllCurvesToEqualLinearDensity)
{
  const SourceSet set = gatherSources({sampleSources(ring(100, 1.0, 0.0, true), 0.1),
                                       sampleSources(ring(100, 1.0, 0.0, true), 0.02)});
  for (const SourceCurve& curve : set.curves) {
    double charge = 0.0;
    for (const FieldSource& source : curve.sources)
      charge += source.charge;
    EXPECT_NEAR(charge * set.spacing, curve.length, 1e-9);
  }
}

/** \brief A hole of radius 1 in a far larger island, and an island of another radius a
 * distance below it. */
std::ptrdiff_t
sourcesWithNeighbour(double radius, double distance, double reach)
{
  BoundaryLoops loops(3);
  loops[0] = {0, {}, {}, ring(300, 50.0, 0.0, true), 0.0};
  loops[1] = {0, {}, {}, ring(30, 1.0, 0.0, false), 0.0};
  loops[2] = {1, {}, {}, ring(30, radius, -distance, true), 0.0};
  const std::vector<bool> sources =
      areIslandSources(loops, {false, true, false}, reach);
  return std::count(sources.begin(), sources.end(), true);
}

TEST(SourceSampling, CountsAHoleAsLargeAsAnIslandNearby) // C4.46-1
{
  EXPECT_EQ(sourcesWithNeighbour(0.9, 0.5, 1.0), 3);
}

TEST(SourceSampling, LeavesOutAHoleSmallerThanAllIslandsNearby)
{
  EXPECT_EQ(sourcesWithNeighbour(1.1, 0.5, 1.0), 2);
}

TEST(SourceSampling, LeavesOutAHoleWithoutAnIslandInReach)
{
  EXPECT_EQ(sourcesWithNeighbour(0.9, 1.5, 1.0), 2);
}

} // namespace
} // namespace pcl::repair::test
