// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PointBlocks as a search method for any PCL class.
#include <pcl/surface_ccaa/impl/block_search.hpp>

#include "run/point_types.h"

PCL_INSTANTIATE(BlockSearch, PSR_POINT_TYPES)
