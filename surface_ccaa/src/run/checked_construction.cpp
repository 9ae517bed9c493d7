// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: checks before a reconstruction, for the point types of PCL.
#include <pcl/surface_ccaa/impl/checked_construction.hpp>

#include "run/point_types.h"

PCL_INSTANTIATE(CheckedConstruction, PSR_POINT_TYPES)
