// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the repair, stage by stage.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "survey/model_survey.h"
#include "verification/repaired_model.h"

namespace pcl::repair {

/** \brief The method (thesis, Chapter 4) on a model that was read, the box in
 * doc/concepts/repair.md: orient, classify, bridge, extract contours, subdivide, fill,
 * fair, verify; and again on what came out, as long as that closes anything more.
 * \param[in] survey as readSurvey() made it
 * \param[in] cloud that it was read from
 * \param[out] report all but `seconds` of writing
 * \return empty when there is no model (report.reading.problem) or after cancelling */
RepairedModel
repairModel(ModelSurvey survey,
            const pcl::PCLPointCloud2& cloud,
            const RepairParameters& parameters,
            const ccaa::LoopContext& context,
            RepairReport& report);

} // namespace pcl::repair
