// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PointBlocks as a search method for any PCL class.
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface_ccaa/impl/block_search.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(BlockSearch, PCL_XYZ_POINT_TYPES)
