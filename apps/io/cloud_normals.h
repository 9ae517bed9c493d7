// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: adds normals or a sensor position to a cloud with any
// fields.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "model.h"

namespace app {

/** \brief Append normal_x, normal_y and normal_z to every point; the other fields keep
 * their bytes and places.
 * \param[in] normals one a point
 * \return false, with nothing done, when the cloud has one of these fields already */
bool
appendNormals(const pcl::PointCloud<pcl::Normal>& normals, pcl::PCLPointCloud2& cloud);

/** \brief Append the sensor position of a file to every point as vp_x, vp_y and vp_z,
 * as floats, or as doubles where it has more digits or that is wanted. \return false,
 * with nothing done, when it is not known or the cloud has one of these fields already
 */
bool
appendViewpoint(const Viewpoint& viewpoint,
                pcl::PCLPointCloud2& cloud,
                bool as_double = false);

/** \brief Whether floats lose digits of it. */
bool
needsDouble(const Viewpoint& viewpoint);

} // namespace app
