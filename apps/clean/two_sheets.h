// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a cloud has two surfaces close to each other.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace app {

/** \brief For each point 1 where those within \a radius lie in two sheets, as those of
 * a thin wall do: across their plane they form two groups that are farther apart than
 * noise, a curved surface, or an edge could make them. One patch through both would be
 * a surface where there is none.
 * \param[in] least_gap distance of the sheets that counts; less is how well scans lie
 * on each other, in units of the cloud, like \a radius
 * \param[in] threads at least 1 */
std::vector<std::uint8_t>
findTwoSheets(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
              double radius,
              double least_gap,
              int threads);

} // namespace app
