// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bridges of a repair as coloured lines.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/surface_repair/repair_report.h>

#include "inspection.h"

namespace app {

/** \brief The bridges as they were built, less the shift, coloured by quality, with
 * their normals, the islands that they join and whether they divide a hole. */
InspectionLayer
showBridges(const std::vector<pcl::RepairBridge>& bridges,
            const pcl::GlobalShift& shift);

} // namespace app
