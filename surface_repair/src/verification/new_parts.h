// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is new in a repaired model, part by part.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "mesh/triangle.h"
#include "verification/repaired_model.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief New triangles that hang together, with crumbs among them. */
struct NewPart {
  std::size_t piece = 0;
  double area = 0.0;
  Eigen::Vector3d out = Eigen::Vector3d::Zero(); /**< sum of normals times area */
  Position center = Position::Zero();            /**< of area */
  double rim = 0.0;                              /**< its length */
  pcl::index_t point = pcl::UNAVAILABLE;         /**< the lowest on its rim */
  double unsupported = 0.0;                      /**< area */
  double crumb_gap = 0.0;                        /**< from the rim, most of all */
  pcl::index_t crumb = pcl::UNAVAILABLE;         /**< a point of that one */
  bool is_disc = false;
};

/** \brief Of a repaired model, by lowest triangle. Cost: linear.
 * \param[in] crumb_triangles islands of fewer are part of a patch that they lie in */
std::vector<NewPart>
newParts(const RepairedModel& repaired,
         const RepairReport& report,
         std::size_t crumb_triangles);

} // namespace pcl::repair
