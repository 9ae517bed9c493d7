// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which given triangles of a seam stay.
#pragma once

#include "tiles/seam.h"

namespace pcl::ccaa {

/** \brief Triangles of a seam by their numbers there, each list ascending. */
struct SettledSeam {
  std::vector<pcl::index_t> shown;  /**< with one fan for each point */
  std::vector<pcl::index_t> hidden; /**< that stay, but make it several */
  std::vector<pcl::index_t> removed;
  std::vector<std::uint8_t> is_open; /**< points that may get triangles: those of the
                                          seam, and corners of what goes */
};

/** \brief One fan for each point. What goes at an open point goes for good; at the rim
 * of what was gathered only the rest of a fan is missing. Where all triangles of a
 * point are given and it is no dispute, what stays is one fan. Linear for ordinary
 * seams. \param[in] goes flags of given triangles that are to be made anew \param[in]
 * is_twisted flags of those that cannot be wound like others \param[in] threads at
 * least 1 */
SettledSeam
settleSeam(const Seam& seam,
           const std::vector<std::uint8_t>& goes,
           const std::vector<std::uint8_t>& is_twisted,
           int threads);

} // namespace pcl::ccaa
