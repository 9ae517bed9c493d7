// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: times, memory and the JSON report of a run.
#pragma once

#include "io/model.h"
#include "io/output_file.h"
#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace app {

/** \brief Wall-clock seconds since it was made or restarted. */
class Stopwatch {
public:
  /** \brief Seconds so far; starts again from zero. */
  double
  lap();

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/** \brief Name and wall-clock seconds of the stages of a run, in order. */
using StageTimes = std::vector<std::pair<std::string, double>>;

/** \brief Of the project, such as "1.0.0". */
std::string
version();

/** \brief Largest memory of this process so far, in bytes. */
std::size_t
peakMemoryBytes();

/** \brief Memory of this process now, in bytes; 0 where the system does not tell. */
std::size_t
currentMemoryBytes();

/** \brief Stages as [{name, seconds, us_per_point}]; \a points at least 1. */
nlohmann::json
describeStages(const StageTimes& stages, std::size_t points);

/** \brief The sum of all stages. */
double
totalSeconds(const StageTimes& stages);

/** \brief What the reports of all programs tell. */
struct RunFacts {
  std::string program;
  std::string input;
  std::string output; /**< empty: none */
  ExitCode exit_code = DONE;
  double seconds = 0; /**< of the work, without reading and writing files */
};

/** rief Add program, version, input, output, exit_code, complete, seconds, the
 * global_shift of the model and, where its remarks name any, units. */
void
addRunFacts(const RunFacts& facts, const Model& model, nlohmann::json& report);

/** \brief Write \a report, readable, into an opened file. */
void
writeReport(const nlohmann::json& report, OutputFile& file);

} // namespace app
