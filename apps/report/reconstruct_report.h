// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what pcl_ccaa_reconstruct tells about a run.
#pragma once

#include "cli/reconstruct_run.h"
#include <nlohmann/json_fwd.hpp>

namespace app {

/** \brief What a filter has found and removed. */
nlohmann::json
describeFilter(const pcl::UmbrellaReport& filter);

/** \brief What cleaning has made of a cloud. */
nlohmann::json
describeCleaning(const CleanReport& cleaning);

/** \brief The JSON report; its keys are explained in doc/apps.md. */
nlohmann::json
describeRun(const ReconstructSettings& settings,
            const ReconstructResult& result,
            const Warnings& warnings);

/** \brief What cleaning has made of a cloud, in a sentence. */
std::string
tellCleaning(const CleanReport& cleaning);

/** \brief What was read, and what a run would go by. */
nlohmann::json
describeInput(const ReconstructSettings& settings, const Model& model);

/** \brief The same in one line. */
std::string
summarizeInput(const ReconstructSettings& settings, const Model& model);

/** \brief A run in one line. */
std::string
summarizeRun(const ReconstructSettings& settings, const ReconstructResult& result);

/** \brief The row of table T3.5-1 for this cloud, below its head. */
std::string
tabulateSpeedup(const pcl::SpeedupReport& speedup);

} // namespace app
