// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application for the point types of PCL.
#include <pcl/surface_ccaa/impl/consecutive_reconstruction.hpp>

#include "run/point_types.h"

PCL_INSTANTIATE(ConsecutiveReconstruction, PSR_POINT_TYPES)
