// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a cloud by the ranks of a run.
#pragma once

#include "greedy/ranked_points.h"
#include "mesh/curve_order.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Points in a given order, one per place.
 * \param[in] points the cloud
 * \param[in] order indices into it */
RankedPoints
rankPoints(const PointArray& points, const std::vector<index_t>& order, int threads);

} // namespace pcl::ccaa
