// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how dense a cloud is, and from how far it is a surface.
#include "cloud_scale.h"

#include <pcl/common/centroid.h>
#include <pcl/surface_ccaa/block_search.h>

#include <Eigen/Eigenvalues>

#include "mesh/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace app {
namespace {

constexpr std::size_t SAMPLES = 1000;
constexpr int SPACING_NEIGHBORS = 6;
constexpr int FEWEST_NEIGHBORS = 12;
constexpr int MOST_NEIGHBORS = 3072;
/** Deviation across the surface over the lesser one along it; a ball has 1. */
constexpr double FLAT = 0.25;

/** The neighbours of some points of a cloud. */
class Sample {
public:
  explicit Sample(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points)
  : points_(points), step_((points->size() + SAMPLES - 1) / SAMPLES)
  {
    search_.setInputCloud(points);
  }

  /** The median over the sample of what \a measure says of the \a count nearest and
   * their squared distances. */
  template <typename Measure>
  double
  median(int count, const Measure& measure) const
  {
    std::vector<double> values;
    pcl::Indices near;
    std::vector<float> sqr_distances;
    for (std::size_t i = 0; i < points_->size(); i += step_) {
      search_.nearestKSearch((*points_)[i], count, near, sqr_distances);
      values.push_back(measure(near, sqr_distances));
    }
    return pcl::ccaa::medianOf(std::move(values));
  }

  double
  thickness(const pcl::Indices& near) const
  {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector4d center;
    pcl::computeMeanAndCovarianceMatrix(*points_, near, covariance, center);
    const Eigen::Vector3d spreads = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                        covariance, Eigen::EigenvaluesOnly)
                                        .eigenvalues()
                                        .cwiseMax(0.0)
                                        .cwiseSqrt();
    return spreads[1] > 0 ? spreads[0] / spreads[1] : 0.0;
  }

  double
  radiusOf(int count) const
  {
    return median(count, [](const pcl::Indices&, const std::vector<float>& found) {
      return std::sqrt(double{found.back()});
    });
  }

  /** The fewest neighbours that are flat, or else the flattest: with more, rods and
   * walls count as thick. */
  int
  flattest() const
  {
    const int most =
        static_cast<int>(std::min<std::size_t>(MOST_NEIGHBORS, points_->size() / 4));
    int best = FEWEST_NEIGHBORS;
    double least = std::numeric_limits<double>::infinity();
    for (int count = FEWEST_NEIGHBORS; least > FLAT && count <= most; count *= 2) {
      const double now =
          median(count, [&](const pcl::Indices& near, const std::vector<float>&) {
            return thickness(near);
          });
      if (now < least) {
        least = now;
        best = count;
      }
    }
    return best;
  }

private:
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points_;
  std::size_t step_;
  pcl::search::BlockSearch<pcl::PointXYZ> search_;
};

} // namespace

CloudScale
measureScale(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points)
{
  const Sample sample(points);
  CloudScale scale;
  // The point itself is the nearest, at distance 0.
  scale.spacing = sample.median(
      SPACING_NEIGHBORS + 1, [](const pcl::Indices&, const std::vector<float>& found) {
        double sum = 0;
        for (const float sqr_distance : found)
          sum += sqr_distance;
        return std::sqrt(sum / SPACING_NEIGHBORS);
      });
  scale.flat_radius = sample.radiusOf(sample.flattest());
  return scale;
}

} // namespace app
