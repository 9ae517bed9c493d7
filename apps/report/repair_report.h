// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what pcl_repair_holes tells about a model.
#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "cli/repair_options.h"
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace app {

/** \brief Everything that was found, for the JSON report. */
nlohmann::json
describeSurvey(const RepairSettings& settings,
               const pcl::repair::ModelSurvey& survey,
               const Warnings& warnings);

/** \brief The repair with its files and parameters, for the JSON report. */
nlohmann::json
describeRun(const RepairSettings& settings,
            const pcl::RepairReport& report,
            const Warnings& warnings);

/** \brief A few lines for people. */
std::string
summarizeSurvey(const RepairSettings& settings, const pcl::repair::ModelSurvey& survey);

} // namespace app
