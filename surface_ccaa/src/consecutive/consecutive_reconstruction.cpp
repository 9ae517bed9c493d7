// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application for the point types of PCL.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/consecutive_reconstruction.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(ConsecutiveReconstruction, PCL_XYZ_POINT_TYPES)
