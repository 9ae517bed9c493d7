// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the greedy start for the point types of PCL.
#include <pcl/surface_ccaa/impl/greedy_start.hpp>

#include "run/point_types.h"

PCL_INSTANTIATE(GreedyStart, PSR_POINT_TYPES)
