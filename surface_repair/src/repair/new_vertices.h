// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what new vertices inherit.

#pragma once

#include <pcl/surface_ccaa/mesh/cloud_access.h>

#include "repair_run.h"

#include <vector>

namespace pcl {
namespace repair {

/** \brief The vertices that have no point of the cloud yet, in their order. Each
 * inherits from input vertices at the boundary of its patch, the nearer the more. */
std::vector<ccaa::NewVertex>
newVertices(const RepairedModel& repaired);

} // namespace repair
} // namespace pcl
