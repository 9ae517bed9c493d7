// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm for the point types of PCL.
#include <pcl/surface_ccaa/impl/projection_completion.hpp>

#include "run/point_types.h"

PCL_INSTANTIATE(ProjectionCompletion, PSR_POINT_TYPES)
