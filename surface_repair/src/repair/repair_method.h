// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair, stage by stage.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "repair/repaired_model.h"

namespace pcl {
namespace repair {

/** \brief The method (thesis, Chapter 4): read, orient, classify, bridge, extract
 * contours, subdivide, fill, fair, verify; and again on what came out, as long as that
 * closes anything more.
 * \param[out] report all but `seconds` of writing
 * \return empty when there is no model (report.reading.problem) or after cancelling */
RepairedModel
runRepair(const pcl::PolygonMesh::ConstPtr& mesh,
          const pcl::PCLPointCloud2* free_points,
          const RepairParameters& parameters,
          const ccaa::LoopContext& context,
          RepairReport& report);

} // namespace repair
} // namespace pcl
