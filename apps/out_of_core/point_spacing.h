// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far apart the points of a tile lie.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace app {

/** \brief Mean distances to the six nearest points; where points lie in lines, times by
 * how much edges may be longer there (see pcl::ccaa::ScanLines). 0 where there are too
 * few. */
std::vector<float>
spacingsOf(const std::vector<Eigen::Vector3f>& points);

} // namespace app
