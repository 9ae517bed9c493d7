// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm for the point types of PCL.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/projection_completion.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(ProjectionCompletion, PCL_XYZ_POINT_TYPES)
