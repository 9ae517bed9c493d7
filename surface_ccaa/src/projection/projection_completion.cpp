// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm for the point types of PCL.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/projection_completion.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(ProjectionCompletion,
                (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
                    pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZINormal))
