// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a cloud has two surfaces close to each other.
#include "two_sheets.h"

#include <pcl/common/centroid.h>
#include <pcl/surface_ccaa/block_search.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t FEWEST_POINTS = 8;
/** Share of the smaller group. */
constexpr double LEAST_SHARE = 0.05;
/** Distance of the groups' means over the deviation within them: sqrt(12) for heights
 * that are spread evenly, as those of a cap are, and less for noise. */
constexpr double APART = 4.0;

/** Heights in ascending order, parted so that the means of both groups are as different
 * as their sizes let them be (Otsu's threshold). \return whether the groups are sheets
 */
bool
fallApart(const std::vector<double>& heights, double least_gap)
{
  double sum = 0, sqr_sum = 0;
  for (const double height : heights) {
    sum += height;
    sqr_sum += height * height;
  }
  const auto count = static_cast<double>(heights.size());
  double best = 0, gap = 0, sum_below = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    sum_below += heights[i];
    const double below = static_cast<double>(i + 1);
    const double above = count - below;
    if (std::min(below, above) < LEAST_SHARE * count)
      continue;
    const double apart = (sum - sum_below) / above - sum_below / below;
    const double between = below * above / count * apart * apart;
    if (between > best) {
      best = between;
      gap = apart;
    }
  }
  const double within = std::max(0.0, sqr_sum - sum * sum / count - best);
  return gap > std::max(least_gap, APART * std::sqrt(within / count));
}

bool
liesInTwoSheets(const pcl::PointCloud<pcl::PointXYZ>& points,
                const pcl::Indices& near,
                double least_gap)
{
  if (near.size() < FEWEST_POINTS)
    return false;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector4d center = Eigen::Vector4d::Zero();
  pcl::computeMeanAndCovarianceMatrix(points, near, covariance, center);
  const Eigen::Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  std::vector<double> heights;
  heights.reserve(near.size());
  for (const pcl::index_t i : near)
    heights.push_back(
        normal.dot(points[static_cast<std::size_t>(i)].getVector3fMap().cast<double>() -
                   center.head<3>()));
  std::sort(heights.begin(), heights.end());
  return fallApart(heights, least_gap);
}

} // namespace

std::vector<std::uint8_t>
findTwoSheets(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
              double radius,
              double least_gap,
              int threads)
{
  pcl::search::BlockSearch<pcl::PointXYZ> search;
  search.setInputCloud(points);
  std::vector<std::uint8_t> found(points->size(), 0);
  const auto count = static_cast<std::ptrdiff_t>(points->size());
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto point = static_cast<std::size_t>(i);
    pcl::Indices near;
    std::vector<float> sqr_distances;
    search.radiusSearch((*points)[point], radius, near, sqr_distances);
    found[point] = liesInTwoSheets(*points, near, least_gap) ? 1 : 0;
  }
  return found;
}

} // namespace app
