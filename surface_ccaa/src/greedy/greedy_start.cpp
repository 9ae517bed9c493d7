// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the greedy start for the point types of PCL.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/greedy_start.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(GreedyStart, PCL_XYZ_POINT_TYPES)
