// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what holds for the chain on any cloud, over seeds.
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "support/mesh_topology.h"
#include "support/random_source.h"
#include "support/repair_shapes.h"
#include "support/single_view.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

/** \brief A random surface with holes, noise, repeated, scattered and not finite points
 * in mixed order. */
Positions
randomCloud(std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points = randomlyDamaged(seed).damaged.vertices;
  const std::size_t surface = points.size();
  if (random.uniform() < 0.5)
    points = withNoise(std::move(points), random.uniform(0.0, 0.02), seed);
  for (std::size_t i = random.below(surface / 10 + 1); i > 0; --i)
    points.push_back(points[random.below(surface)]);
  for (std::size_t i = random.below(20); i > 0; --i)
    points.emplace_back(
        random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
  if (random.uniform() < 0.5)
    points = withNonFinite(std::move(points), 5, seed);
  return shuffled(std::move(points), seed);
}

Triangles
reconstructed(const Positions& points,
              unsigned int threads = 1,
              const IndicesPtr& indices = nullptr)
{
  ConsecutiveReconstruction<PointXYZ> reconstruction;
  reconstruction.setInputCloud(toCloud(points));
  if (indices)
    reconstruction.setIndices(indices);
  reconstruction.setNumberOfThreads(threads);
  std::vector<Vertices> polygons;
  reconstruction.reconstruct(polygons);
  return toTriangles(polygons);
}

/** Noise of 0.6 spacings folds the surface everywhere; half of it was inside out where
 * a few wrong triangles turned large patches over. */
TEST(ReconstructionOfNoise, FacesOutwardNearlyEverywhere)
{
  constexpr std::size_t COUNT = 10000;
  const double spacing = std::sqrt(4.0 * M_PI / double(COUNT));
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Positions points = withNoise(fibonacciSphere(COUNT), 0.6 * spacing, seed);
    ConsecutiveReconstruction<PointXYZ> reconstruction;
    reconstruction.setInputCloud(toCloud(points));
    std::vector<Vertices> polygons;
    reconstruction.reconstruct(polygons);
    EXPECT_LT(facingShare(polygons, points, Position::Zero()), 0.1) << seed;
  }
}

class ReconstructionOfRandomClouds : public ::testing::TestWithParam<std::uint64_t> {
protected:
  const Positions points_ = randomCloud(GetParam());
};

TEST_P(ReconstructionOfRandomClouds, IsACorrectSurface)
{
  const Triangles triangles = reconstructed(points_);
  EXPECT_TRUE(isIcadm(triangles, points_.size()));
  EXPECT_TRUE(isConsistentlyWound(triangles));
}

TEST_P(ReconstructionOfRandomClouds, IsTheSameForAnyNumberOfThreads)
{
  EXPECT_EQ(reconstructed(points_, 1), reconstructed(points_, 5));
}

/** Powers of two change no digit, so nothing may depend on the unit. */
TEST_P(ReconstructionOfRandomClouds, IsTheSameInAnyUnit)
{
  EXPECT_EQ(reconstructed(points_), reconstructed(scaled(points_, 1024.0)));
}

TEST_P(ReconstructionOfRandomClouds, OfASelectionIsThatOfItsPoints)
{
  const auto indices = pcl::make_shared<Indices>();
  Positions chosen;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (i % 7 != 0) {
      indices->push_back(static_cast<index_t>(i));
      chosen.push_back(points_[i]);
    }
  Triangles expected = reconstructed(chosen);
  for (Triangle& triangle : expected)
    for (index_t& corner : triangle)
      corner = (*indices)[static_cast<std::size_t>(corner)];
  EXPECT_EQ(expected, reconstructed(points_, 1, indices));
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         ReconstructionOfRandomClouds,
                         ::testing::Range<std::uint64_t>(1, 13));

class ReconstructionOfScanLines : public ::testing::TestWithParam<double> {};

TEST_P(ReconstructionOfScanLines, ClosesASphere)
{
  const Positions points = sphereLines(8000, GetParam());
  const Triangles triangles = reconstructed(points);
  EXPECT_EQ(countBoundaryEdges(triangles), 0u);
  EXPECT_EQ(topologyOf(triangles).characteristic, 2);
}

INSTANTIATE_TEST_SUITE_P(Gaps,
                         ReconstructionOfScanLines,
                         ::testing::Values(5.0, 7.0, 10.0, 15.0, 20.0));

/** Points at random on a torus, without an order: some are a hundred times nearer to
 * each other than others. */
Positions
randomPointsOnTorus(std::size_t count, std::uint64_t seed)
{
  constexpr double TUBE = 0.4;
  RandomSource random(seed);
  Positions points;
  while (points.size() < count) {
    const double along = random.uniform(0.0, 2.0 * M_PI);
    const double around = random.uniform(0.0, 2.0 * M_PI);
    const double radius = 1.0 + TUBE * std::cos(around);
    if (random.uniform(0.0, 1.0 + TUBE) < radius)
      points.emplace_back(
          radius * std::cos(along), radius * std::sin(along), TUBE * std::sin(around));
  }
  return points;
}

/** Points at random on a washer: a ring with four sharp edges. */
Positions
randomPointsOnWasher(std::size_t count, std::uint64_t seed)
{
  constexpr double INNER = 0.5, OUTER = 1.0, HEIGHT = 0.3;
  constexpr double FACE = OUTER * OUTER - INNER * INNER; // areas over pi
  constexpr double WALLS = 2.0 * (INNER + OUTER) * HEIGHT;
  RandomSource random(seed);
  Positions points;
  while (points.size() < count) {
    const double along = random.uniform(0.0, 2.0 * M_PI);
    double radius = random.uniform() < INNER / (INNER + OUTER) ? INNER : OUTER;
    double z = random.uniform(0.0, HEIGHT);
    if (random.uniform(0.0, 2.0 * FACE + WALLS) > WALLS) {
      radius = std::sqrt(INNER * INNER + FACE * random.uniform());
      z = random.uniform() < 0.5 ? 0.0 : HEIGHT;
    }
    points.emplace_back(radius * std::cos(along), radius * std::sin(along), z);
  }
  return points;
}

/** Points at random on a bar: a box ten times as long as it is wide and high. */
Positions
randomPointsOnBar(std::size_t count, std::uint64_t seed)
{
  const Position size(3.0, 0.3, 0.3);
  RandomSource random(seed);
  Positions points;
  while (points.size() < count) {
    Position point(random.uniform(), random.uniform(), random.uniform());
    const double end = size.y() * size.z(), side = size.x() * size.y();
    const bool is_end = random.uniform(0.0, end + 2.0 * side) < end;
    const Eigen::Index axis = is_end ? 0 : random.uniform() < 0.5 ? 1 : 2;
    point[axis] = random.uniform() < 0.5 ? 0.0 : 1.0;
    points.push_back(point.cwiseProduct(size));
  }
  return points;
}

class ReconstructionOfRandomPoints : public ::testing::TestWithParam<std::uint64_t> {};

/** Where the start folds triangles back onto others, what hangs on them was wound the
 * wrong way, and such folds passed for thin places of the body. */
TEST_P(ReconstructionOfRandomPoints, UsesAllAndHasNoHandleInDoubt)
{
  ConsecutiveReconstruction<PointXYZ> reconstruction;
  reconstruction.setInputCloud(toCloud(randomPointsOnTorus(40000, GetParam())));
  std::vector<Vertices> polygons;
  reconstruction.reconstruct(polygons);
  const auto& report = reconstruction.getReport();
  EXPECT_EQ(report.free_points, 0u);
  EXPECT_EQ(report.doubts.handles, 0u);
}

/** At sharp edges the start makes thin places that the base algorithm takes away. */
TEST_P(ReconstructionOfRandomPoints, HasNoHandleInDoubtBesideSharpEdges)
{
  ConsecutiveReconstruction<PointXYZ> reconstruction;
  reconstruction.setInputCloud(toCloud(randomPointsOnWasher(20000, GetParam())));
  std::vector<Vertices> polygons;
  reconstruction.reconstruct(polygons);
  EXPECT_EQ(topologyOf(toTriangles(polygons)).characteristic, 0);
  EXPECT_EQ(reconstruction.getReport().doubts.handles, 0u);
}

/** Samples at random lie far apart in places; at edges small handles grew. */
TEST_P(ReconstructionOfRandomPoints, HasNoGapsAndNoSmallHandles)
{
  const Triangles triangles = reconstructed(randomPointsOnBar(20000, GetParam()));
  EXPECT_EQ(countBoundaryEdges(triangles), 0u);
  EXPECT_EQ(topologyOf(triangles).characteristic, 2);
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         ReconstructionOfRandomPoints,
                         ::testing::Range<std::uint64_t>(1, 13));

INSTANTIATE_TEST_SUITE_P(SeedsOfSmallHandlesAndGaps,
                         ReconstructionOfRandomPoints,
                         ::testing::Values(29, 39, 41, 47, 52));

} // namespace
} // namespace pcl::ccaa::test
