// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far apart the points of a tile lie.
#pragma once

#include "greedy/ranked_points.h"

#include <vector>

namespace app {

/** \brief Mean distances of points to their six nearest; where points lie in lines,
 * times by how much edges may be longer there (see pcl::ccaa::ScanLines). 0 where there
 * are too few. */
std::vector<float>
spacingsOf(const pcl::ccaa::RankedPoints& points, int threads);

} // namespace app
