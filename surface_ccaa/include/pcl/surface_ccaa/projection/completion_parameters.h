// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: settings and report of the base algorithm.
#pragma once

#include <pcl/surface_ccaa/mesh/side_hints.h>

#include <cstddef>

namespace pcl {
namespace ccaa {

/** \brief Settings of the base algorithm; the defaults need no knowledge of the cloud.
 */
struct CompletionParameters {
  /** \brief Open points around an open point among which its triangles are sought, 6 to
   * 64. */
  unsigned int neighbors = 20;
  /** \brief Largest circumradius of a new triangle as a multiple of the local spacing:
   * wider gaps have no samples to support a surface and stay open. */
  double support = 2.0;
  /** \brief Angle in radians between the normals of neighboring triangles up to which
   * the surface counts as smooth; 30 degrees. Folds beyond wait until last. */
  double smooth_fold = 0.5235987755982988;
  /** \brief Largest angle between the normals of neighboring triangles; 150 degrees. */
  double largest_fold = 2.6179938779914944;
  /** \brief A region that grew by itself stays only with so many internal points. */
  std::size_t minimum_internal_points = 10;
  /** \brief Keep every given triangle, whatever it looks like. With false the given
   * ones that are doubtful (see doubtfulTriangles()) or that obstruct the completion
   * may be replaced. */
  bool keep_given = true;
};

/** \brief What one run of the base algorithm did. */
struct CompletionReport {
  std::size_t given_triangles = 0;
  std::size_t kept_triangles = 0; /**< given ones in the result */
  std::size_t new_triangles = 0;
  std::size_t open_points = 0; /**< boundary points and free points before */
  std::size_t free_points = 0; /**< points without a triangle after */
  SideTally sides;             /**< what told the outer side of the result */
  double seconds = 0;
  bool cancelled = false;
};

} // namespace ccaa
} // namespace pcl
