// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: checks before a reconstruction, for the point types of PCL.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/checked_construction.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(CheckedConstruction, PCL_XYZ_POINT_TYPES)
