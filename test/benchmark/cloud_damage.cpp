// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: noise, gaps in density and outliers for benchmark clouds.
#include "cloud_damage.h"

#include <pcl/surface_ccaa/impl/point_blocks.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace bench {
namespace {

// One seed for each kind of damage: two of them on one cloud are independent.
constexpr unsigned int NOISE_SEED = 11;
constexpr unsigned int THINNING_SEED = 13;
constexpr unsigned int OUTLIER_SEED = 17;
constexpr unsigned int GRADING_SEED = 19;

Eigen::AlignedBox3d
boxOf(const Cloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& point : cloud)
    box.extend(point.getVector3fMap().cast<double>().eval());
  return box;
}

/** Root mean square of a row of squared distances; a row may end early. */
double
rowSpacing(const float* sqr_distances, unsigned int k)
{
  double sum = 0;
  unsigned int count = 0;
  for (; count < k && std::isfinite(sqr_distances[count]); ++count)
    sum += double(sqr_distances[count]);
  return count == 0 ? 0 : std::sqrt(sum / count);
}

} // namespace

double
meanSpacing(const Cloud& cloud)
{
  if (cloud.size() < 2)
    return 0;
  pcl::ccaa::PointBlocks blocks;
  blocks.build({cloud[0].data, sizeof(pcl::PointXYZ) / sizeof(float), cloud.size()}, 1);
  const auto table = blocks.allNearest(6, pcl::ccaa::PointBlocks::Distances::KEEP, 1);
  double sum = 0;
  for (std::size_t rank = 0; rank < table->rows(); ++rank)
    sum += rowSpacing(table->sqrDistances(rank), table->k());
  return sum / double(table->rows());
}

void
addNoise(Cloud& cloud, double sigma)
{
  const double deviation = sigma * meanSpacing(cloud);
  std::mt19937 random(NOISE_SEED);
  std::normal_distribution<double> normal;
  for (pcl::PointXYZ& point : cloud)
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = float(double(point.data[axis]) + deviation * normal(random));
}

Cloud
thinOut(const Cloud& cloud, double share)
{
  std::mt19937 random(THINNING_SEED);
  std::uniform_real_distribution<double> uniform;
  Cloud kept;
  for (const pcl::PointXYZ& point : cloud)
    if (uniform(random) < share)
      kept.push_back(point);
  return kept;
}

void
addOutliers(Cloud& cloud, double share)
{
  const Eigen::AlignedBox3d box = boxOf(cloud);
  const double margin = 0.05 * box.diagonal().norm();
  const Eigen::Vector3d low = box.min().array() - margin;
  const Eigen::Vector3d size = box.sizes().array() + 2 * margin;
  std::mt19937 random(OUTLIER_SEED);
  std::uniform_real_distribution<double> uniform;
  const auto count =
      static_cast<std::size_t>(std::llround(share * double(cloud.size())));
  for (std::size_t i = 0; i < count; ++i) {
    pcl::PointXYZ point;
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = float(low[axis] + uniform(random) * size[axis]);
    cloud.push_back(point);
  }
}

Cloud
gradeDensity(const Cloud& cloud, double factor)
{
  const Eigen::AlignedBox3d box = boxOf(cloud);
  Eigen::Index axis = 0;
  const double length = box.sizes().maxCoeff(&axis);
  std::mt19937 random(GRADING_SEED);
  std::uniform_real_distribution<double> uniform;
  Cloud kept;
  for (const pcl::PointXYZ& point : cloud) {
    const double along = (double(point.data[axis]) - box.min()[axis]) / length;
    if (uniform(random) < std::pow(factor, -along))
      kept.push_back(point);
  }
  return kept;
}

} // namespace bench
