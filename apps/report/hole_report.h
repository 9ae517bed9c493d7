// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is told about a repair.
#pragma once

#include <pcl/surface_repair/repair_report.h>
#include <pcl/PolygonMesh.h>

#include "io/model.h"
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace app {

/** \brief Everything about the model and its repair, for the JSON report. */
nlohmann::json
describeRepair(const pcl::RepairReport& report);

/** \brief The same in one line, without the name of a file. */
std::string
summarizeRepair(const pcl::RepairReport& report);

/** \brief Where a point of a mesh is, such as "at point 7, 0.5 0 1"; empty for -1. */
std::string
placeOf(pcl::index_t number, const pcl::PolygonMesh& mesh);

/** \brief What should be closed and is not, and what is in doubt: one sentence a
 * reason, with the number of such holes and a place where one is; empty if there is
 * none. \param[in] mesh the repaired one */
std::string
tellShortfalls(const pcl::RepairReport& report, const pcl::PolygonMesh& mesh);

/** \brief How each triangle came about: 0 input, 1 fan, 2 minimum weight, 3 completion.
 */
FaceProperty
originProperty(const pcl::RepairReport& report);

} // namespace app
