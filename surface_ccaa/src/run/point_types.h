// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the point types the library holds its templates for.
#pragma once

#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#ifdef PSR_FEW_POINT_TYPES
/// What the programs use: plain, with normals, with sensors. The other fifteen go
/// through the same code, and with sanitizers they take a minute to compile.
#define PSR_POINT_TYPES (pcl::PointXYZ)(pcl::PointNormal)(pcl::PointWithViewpoint)
#else
#define PSR_POINT_TYPES PCL_XYZ_POINT_TYPES
#endif
