// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a sensor has seen faces it after all stages.

#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/random_source.h"
#include "support/shapes.h"
#include "support/single_view.h"

namespace pcl::ccaa::test {
namespace {

constexpr double LEAST_SHARE = 0.97;
constexpr std::uint64_t SEEDS = 6;

template <typename PointT>
typename PointCloud<PointT>::Ptr
cloudOf(const Positions& points)
{
  auto cloud = std::make_shared<PointCloud<PointT>>();
  for (const Position& point : points) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = point.cast<float>();
  }
  return cloud;
}

PointCloud<PointXYZ>::Ptr
withSensorOrigin(const SingleView& view)
{
  auto cloud = cloudOf<PointXYZ>(view.points);
  cloud->sensor_origin_.head<3>() = view.sensor.cast<float>();
  return cloud;
}

void
setSensor(const Position& sensor, PointWithViewpoint& point)
{
  point.vp_x = static_cast<float>(sensor.x());
  point.vp_y = static_cast<float>(sensor.y());
  point.vp_z = static_cast<float>(sensor.z());
}

/** Triangles of a chain, and what told their sides. */
struct Result {
  std::vector<Vertices> triangles;
  SideTally tally;
};

template <typename PointT>
Result
reconstruct(const typename PointCloud<PointT>::ConstPtr& cloud,
            ConsecutiveReconstruction<PointT>& chain)
{
  Result result;
  chain.setInputCloud(cloud);
  chain.reconstruct(result.triangles);
  result.tally = chain.getSideTally();
  return result;
}

template <typename PointT>
Result
reconstruct(const typename PointCloud<PointT>::ConstPtr& cloud)
{
  ConsecutiveReconstruction<PointT> chain;
  return reconstruct<PointT>(cloud, chain);
}

TEST(SingleView, FacesTheSensorAfterTheFilter)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const SingleView view = singleView(seed);
    ConsecutiveReconstruction<PointXYZ> chain;
    chain.setBaseAlgorithm(nullptr);
    const Result result = reconstruct<PointXYZ>(withSensorOrigin(view), chain);
    EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE)
        << seed;
  }
}

TEST(SingleView, FacesTheSensorAfterTheBase)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const SingleView view = singleView(seed);
    const Result result = reconstruct<PointXYZ>(withSensorOrigin(view));
    EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE)
        << seed;
    EXPECT_GT(result.tally[OutwardRule::VIEWPOINT], 0u);
  }
}

TEST(SingleView, FacesTheViewpointThatIsTold)
{
  const SingleView view = singleView(3);
  ConsecutiveReconstruction<PointXYZ> chain;
  chain.setViewpoint(view.sensor);
  const Result result = reconstruct<PointXYZ>(cloudOf<PointXYZ>(view.points), chain);
  EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE);
  EXPECT_GT(result.tally[OutwardRule::TOLD_VIEWPOINT], 0u);
}

TEST(SingleView, FacesTheOriginInTheFrameOfItsSensor)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const SingleView view = inSensorFrame(singleView(seed));
    const Result result = reconstruct<PointXYZ>(cloudOf<PointXYZ>(view.points));
    EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE)
        << seed;
    EXPECT_GT(result.tally[OutwardRule::ORIGIN], 0u) << seed;
  }
}

TEST(SingleView, DoesNotTakeTheOriginForTheSensorIfItMayNot)
{
  const SingleView view = inSensorFrame(singleView(1));
  ConsecutiveReconstruction<PointXYZ> chain;
  chain.setOriginAsViewpoint(false);
  EXPECT_EQ(reconstruct<PointXYZ>(cloudOf<PointXYZ>(view.points), chain)
                .tally[OutwardRule::ORIGIN],
            0u);
}

TEST(SingleView, OfSeveralSensorsFacesTheSensorOfEachPoint)
{
  SingleView both = singleView(1);
  const SingleView second = singleView(2);
  const std::size_t first_points = both.points.size();
  const Position apart(20.0, 0.0, 0.0);
  for (const Position& point : second.points)
    both.points.push_back(point + apart);
  const auto cloud = cloudOf<PointWithViewpoint>(both.points);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    setSensor(i < first_points ? both.sensor : Position(second.sensor + apart),
              (*cloud)[i]);
  const Result result = reconstruct<PointWithViewpoint>(cloud);
  std::vector<Vertices> of_first, of_second;
  for (const Vertices& triangle : result.triangles)
    (static_cast<std::size_t>(triangle.vertices[0]) < first_points ? of_first
                                                                   : of_second)
        .push_back(triangle);
  EXPECT_GE(facingShare(of_first, both.points, both.sensor), LEAST_SHARE);
  EXPECT_GE(facingShare(of_second, both.points, second.sensor + apart), LEAST_SHARE);
}

/** A view whose points have normals that look away from the sensor. */
PointCloud<PointNormal>::Ptr
withNormalsAway(const SingleView& view)
{
  auto cloud = cloudOf<PointNormal>(view.points);
  for (PointNormal& point : *cloud)
    point.getNormalVector3fMap() = point.getVector3fMap() - view.sensor.cast<float>();
  cloud->sensor_origin_.head<3>() = view.sensor.cast<float>();
  return cloud;
}

TEST(SingleView, FollowsNormalsBeforeTheSensorOfTheCloud)
{
  const SingleView view = singleView(4);
  const Result result = reconstruct<PointNormal>(withNormalsAway(view));
  EXPECT_LE(facingShare(result.triangles, view.points, view.sensor), 1.0 - LEAST_SHARE);
}

TEST(SingleView, FollowsTheViewpointThatIsToldBeforeNormals)
{
  const SingleView view = singleView(4);
  ConsecutiveReconstruction<PointNormal> chain;
  chain.setViewpoint(view.sensor);
  const Result result = reconstruct<PointNormal>(withNormalsAway(view), chain);
  EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE);
}

TEST(SingleView, FollowsTheSensorWhereNormalsSayNothing)
{
  const SingleView view = singleView(5);
  auto cloud = withNormalsAway(view);
  RandomSource random(1);
  for (PointNormal& point : *cloud)
    if (random.uniform() < 0.5)
      point.getNormalVector3fMap() *= -1.0f;
  const Result result = reconstruct<PointNormal>(cloud);
  EXPECT_GE(facingShare(result.triangles, view.points, view.sensor), LEAST_SHARE);
}

/** \brief What of a terrain looks to the sky. */
double
upwardShare(const Result& result, const Positions& points)
{
  return facingShare(result.triangles, points, {20.0, 20.0, 1e6});
}

TEST(Terrain, LooksToWhereItIsToldThatUpIs)
{
  const Positions points = terrainCloud(40);
  for (const double sign : {1.0, -1.0}) {
    ConsecutiveReconstruction<PointXYZ> chain;
    chain.setUp(Position(0.1, 0.0, sign));
    const Result result = reconstruct<PointXYZ>(cloudOf<PointXYZ>(points), chain);
    EXPECT_EQ(upwardShare(result, points), sign > 0.0 ? 1.0 : 0.0);
    EXPECT_EQ(result.tally[OutwardRule::UP], result.triangles.size());
  }
}

TEST(Terrain, IsGuessedToLookAlongTheNearestAxisAndSaysSo)
{
  const Positions points = terrainCloud(40);
  const Result result = reconstruct<PointXYZ>(cloudOf<PointXYZ>(points));
  EXPECT_EQ(upwardShare(result, points), 1.0);
  EXPECT_EQ(describe(result.tally), "guessed: up (+z) from the dominant plane");
}

/** The lower side of a plate looks down. */
TEST(Terrain, IsNotGuessedWhereSurfacesLieOverEachOther)
{
  const Positions points = thinPlate(30, 30, 4.0).vertices;
  const Result result = reconstruct<PointXYZ>(cloudOf<PointXYZ>(points));
  EXPECT_EQ(result.tally[OutwardRule::PLANE], 0u);
  EXPECT_NEAR(upwardShare(result, points), 0.5, 0.01);
}

} // namespace
} // namespace pcl::ccaa::test
