// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which open points lie in space and not on a surface.
#include "advancing_front/scattered_points.h"

#include <Eigen/Eigenvalues>

#include "advancing_front/spacing.h"
#include "advancing_front/tuning.h"
#include "mesh/quantile.h"

#include <algorithm>

namespace pcl::ccaa {
namespace {

/** Known spacings where there are any, else from the neighbors. */
std::vector<double>
spacingsOf(const OpenSurface& open)
{
  std::vector<double> spacings = open.spacings;
  for (std::size_t i = 0; i < open.open_points; ++i)
    if (spacings[i] <= 0.0)
      spacings[i] = spacingFromNeighbors(open, static_cast<pcl::index_t>(i));
  return spacings;
}

} // namespace

double
neighborhoodThickness(const OpenSurface& open, pcl::index_t point)
{
  const pcl::index_t* row = open.neighbors.row(point);
  const unsigned int count = open.neighbors.count(point);
  Position mean = Position::Zero();
  for (unsigned int j = 0; j < count; ++j)
    mean += open.positions[static_cast<std::size_t>(row[j])] / count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (unsigned int j = 0; j < count; ++j) {
    const Position offset = open.positions[static_cast<std::size_t>(row[j])] - mean;
    covariance += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance,
                                                              Eigen::EigenvaluesOnly);
  const auto& variances = solver.eigenvalues();
  return variances[2] > 0.0 ? std::max(0.0, variances[0]) / variances[2] : 0.0;
}

std::vector<std::uint8_t>
findScatteredPoints(const OpenSurface& open, double usual_spacing)
{
  const std::vector<double> spacings = spacingsOf(open);
  const double limit = tuning::SCATTERED_SPACING *
                       (usual_spacing > 0.0 ? usual_spacing : medianOf(spacings));
  std::vector<std::uint8_t> used(open.positions.size(), 0);
  for (const Triangle& triangle : open.rim)
    for (const pcl::index_t corner : triangle)
      used[static_cast<std::size_t>(corner)] = 1;
  std::vector<std::uint8_t> scattered(open.open_points, 0);
  for (std::size_t i = 0; i < open.open_points; ++i)
    scattered[i] = used[i] == 0 && spacings[i] > limit &&
                   (spacings[i] > tuning::FAR_RATIO * limit ||
                    neighborhoodThickness(open, static_cast<pcl::index_t>(i)) >
                        tuning::MOST_THICKNESS);
  return scattered;
}

} // namespace pcl::ccaa
