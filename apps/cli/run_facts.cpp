// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: times, memory and the JSON report of a run.
#include "run_facts.h"

#include "io/remarks.h"
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#ifndef PSR_VERSION
#define PSR_VERSION "of an unknown version"
#endif

namespace app {

std::string
version()
{
  return PSR_VERSION;
}

double
Stopwatch::lap()
{
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  start_ = now;
  return seconds;
}

std::size_t
peakMemoryBytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::size_t
currentMemoryBytes()
{
  std::ifstream file("/proc/self/statm");
  std::size_t all_pages = 0;
  std::size_t resident_pages = 0;
  file >> all_pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

nlohmann::json
describeStages(const StageTimes& stages, std::size_t points)
{
  nlohmann::json list = nlohmann::json::array();
  const auto divisor = static_cast<double>(std::max<std::size_t>(points, 1));
  for (const auto& [name, seconds] : stages)
    list.push_back({{"name", name},
                    {"seconds", seconds},
                    {"us_per_point", seconds * 1e6 / divisor}});
  return list;
}

double
totalSeconds(const StageTimes& stages)
{
  double seconds = 0.0;
  for (const auto& stage : stages)
    seconds += stage.second;
  return seconds;
}

void
addRunFacts(const RunFacts& facts, const Model& model, nlohmann::json& report)
{
  report["program"] = facts.program;
  report["version"] = version();
  report["input"] = facts.input;
  report["output"] = nullptr;
  if (!facts.output.empty())
    report["output"] = facts.output;
  report["exit_code"] = facts.exit_code;
  report["complete"] = facts.exit_code == DONE;
  report["seconds"] = facts.seconds;
  report["global_shift"] = model.shift.offset();
  const std::string units = namedUnits(model.remarks);
  if (!units.empty())
    report["units"] = units;
}

void
writeReport(const nlohmann::json& report, OutputFile& file)
{
  // File names need not be valid UTF-8.
  file.text(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  file.text("\n");
}

} // namespace app
