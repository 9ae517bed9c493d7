// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one even layer of points from scans that overlap and
// disagree.
#pragma once

#include "io/model.h"

#include <cstddef>
#include <functional>

namespace app {

/** \brief How a cloud is cleaned. */
struct CleanParameters {
  /** \brief Distance that points keep, in units of the cloud; 0: the median spacing of
   * the cloud. Set it higher where the mesh may be coarser. */
  double spacing = 0;

  /** \brief Radius of the patches that smooth the points, in units of the cloud; 0:
   * four spacings, or where the cloud is thicker, as much as makes it a surface. What
   * is smaller is smoothed away. Set it higher where the mesh is still rough. */
  double radius = 0;

  /** \brief A point is an outlier when its neighbours are this many standard deviations
   * farther away than is usual; 1 or more. Set it lower where strays are left, higher
   * where thin parts vanish. */
  double outlier_deviations = 4.0;
};

/** \brief What became of the points. */
struct CleanReport {
  std::size_t input_points = 0;
  std::size_t skipped_points = 0; /**< not finite */
  std::size_t grid_points = 0;    /**< means of the cells of a grid */
  std::size_t outliers = 0;       /**< of these */
  std::size_t in_two_sheets = 0;  /**< thinner than a patch is wide; not smoothed */
  std::size_t output_points = 0;  /**< 0: too few to be cleaned; nothing was done */
  double spacing = 0;             /**< that was kept, in units of the cloud */
  double radius = 0;              /**< of the patches */
  double moved = 0;               /**< root mean square, of the means that stayed */
  double moved_most = 0;
  std::size_t moved_together = 0; /**< with their neighbours, by half a spacing or more
                                       and more than noise: small parts may be gone */
  Eigen::Vector3d moved_at = Eigen::Vector3d::Zero(); /**< most of all */
};

/** \brief Make one even layer of points: the means of a grid without outliers
 * (pcl::StatisticalOutlierRemoval), each moved onto a smooth patch
 * (pcl::MovingLeastSquares), and of these as many as are \a spacing apart. Where a
 * patch would go through both sides of a thin wall, points are not moved.
 *
 * Each point that results has the fields of those it is made of: numbers with a
 * fraction, normals and colours are mixed; whole numbers, and the place of the sensor
 * (vp_x, vp_y, vp_z), are those of the nearest. A cloud of fewer than 24 different
 * points stays as it is. The same for any number of threads; O(N log N), some 10 us a
 * point, and twice the memory of the cloud.
 * \param[in] threads 0: all
 * \param[in] goes_on asked between the steps with the share that is done; where it
 * says false the model stays as it is */
CleanReport
cleanCloud(const CleanParameters& parameters,
           unsigned int threads,
           const std::function<bool(double)>& goes_on,
           Model& model);

} // namespace app
