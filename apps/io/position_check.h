// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: are the positions of a cloud fit for work?
#pragma once

#include "model.h"
#include "status.h"

#include <cstddef>
#include <string>

namespace app {

/** \brief Set is_dense and the shift; fail for a double beyond the range of floats.
 * Warn when positions in float32 lie so far from the origin that digits are lost in the
 * file already: steps of more than a hundredth of the mean spacing. */
void
checkPositions(Model& model);

/** \brief "596600,5420300,300": as many digits as a double surely has. */
std::string
placeText(const Eigen::Vector3d& place, const char* separator = ",");

/** \brief "0.5 0 1": the same of a place in a cloud with digits as its positions have.
 */
std::string
placeIn(const pcl::PCLPointCloud2& cloud, const Eigen::Vector3d& place);

/** \brief Say in the warnings which shift there is, if any. */
void
noteShift(Model& model);

/** \brief Number of points with finite coordinates at different places, counted only up
 * to \a enough. */
std::size_t
countUsablePoints(const pcl::PCLPointCloud2& cloud, std::size_t enough);

/** \brief Fails, with a sentence about \a name, when there are not enough usable points
 * for a triangle. */
void
requireTrianglePoints(const pcl::PCLPointCloud2& cloud, const std::string& name);

} // namespace app
