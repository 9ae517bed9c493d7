// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the holes of a repair as coloured lines.
#pragma once

#include <pcl/surface_repair/repair_report.h>
#include <pcl/PolygonMesh.h>

#include "inspect/inspection.h"

namespace app {

/** \brief What boundaries and bridges enclose, as it lies in the repaired mesh: the
 * contours of closed holes by the method that closed them, those that stay open by
 * their reason.
 * \param[in] mesh the repaired one */
InspectionLayer
showContours(const pcl::RepairReport& report, const pcl::PolygonMesh& mesh);

} // namespace app
