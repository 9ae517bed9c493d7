// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: are the positions of a cloud fit for work?
#pragma once

#include "model.h"
#include "status.h"

#include <cstddef>
#include <string>

namespace app {

/** \brief Set is_dense, and warn when the cloud lies so far from the origin that
 * float32 cannot tell its points apart: steps of more than a hundredth of the mean
 * spacing, taken as the longest side of the bounding box over the root of the number of
 * points. */
void
checkPositions(Model& model);

/** \brief Number of points with finite coordinates at different places, counted only up
 * to \a enough. */
std::size_t
countUsablePoints(const pcl::PCLPointCloud2& cloud, std::size_t enough);

/** \brief Fails, with a sentence about \a name, when there are not enough usable points
 * for a triangle. */
Status
requireTrianglePoints(const pcl::PCLPointCloud2& cloud, const std::string& name);

} // namespace app
