// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what cleaning does to parts thinner than its patches.
#include "clean/clean_cloud.h"
#include "model_samples.h"
#include "reconstruct_fixture.h"
#include "support/clouds.h"
#include "support/raw_clouds.h"

namespace app_test {
namespace {

app::CleanReport
clean(const pcl::PCLPointCloud2& cloud)
{
  app::Model model;
  model.mesh.cloud = cloud;
  model.shift = pcl::GlobalShift::of(cloud);
  return app::cleanCloud(
      {}, 2, [](double) { return true; }, model);
}

app::CleanReport
clean(const pcl::ccaa::Positions& points)
{
  return clean(test::toRawCloud(points));
}

/** A rod along z, a few points around. */
pcl::ccaa::Positions
rod(double radius)
{
  pcl::ccaa::Positions points = test::cylinderCloud(3000);
  for (pcl::ccaa::Position& point : points) {
    point.head<2>() *= radius;
    point.z() /= radius; // as dense as before
  }
  return points;
}

TEST(CleanCloud, DoesNotTakeARodForAThickCloud)
{
  const app::CleanReport report = clean(rod(0.15));
  EXPECT_LE(report.radius, 4.001 * report.spacing);
  EXPECT_LT(report.moved, 0.5 * report.spacing);
}

constexpr double ROD_RADIUS = 0.1;

pcl::ccaa::Positions
sphereWithRod()
{
  pcl::ccaa::Positions points = test::noisySphere(4000, 0.0); // spacing 0.06
  for (const pcl::ccaa::Position& point : rod(ROD_RADIUS))
    if (point.z() > 0.0)
      points.emplace_back(point.x(), point.y(), 1.0 + 0.1 * point.z());
  return points;
}

TEST(CleanCloud, TellsOfPointsMovedTogetherWhereAPartIsThin)
{
  const app::CleanReport report = clean(sphereWithRod());
  EXPECT_GT(report.moved_together, 0U);
  EXPECT_NEAR(ROD_RADIUS, report.moved_at.head<2>().norm(), 0.5 * ROD_RADIUS);
}

TEST(CleanCloud, TellsInMapCoordinatesWherePointsWereMovedTogether)
{
  const app::CleanReport report =
      clean(test::toDoubleCloud(test::shifted(sphereWithRod(), test::MAP_PLACE)));
  const pcl::ccaa::Position at = report.moved_at - test::MAP_PLACE;
  EXPECT_NEAR(ROD_RADIUS, at.head<2>().norm(), 0.5 * ROD_RADIUS);
}

TEST(CleanCloud, TakesNoNoiseForPointsMovedTogether)
{
  for (const double noise : {0.01, 0.03, 0.1}) // spacing 0.06
    EXPECT_EQ(0U, clean(test::noisySphere(4000, noise)).moved_together) << noise;
}

} // namespace
} // namespace app_test
