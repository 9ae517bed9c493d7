// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one program run over many inputs.
#include "batch.h"

#include "io/interrupt.h"
#include "io/output_folder.h"
#include "io/overwriting.h"
#include "io/wording.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string
outputFor(const BatchSettings& settings, const std::string& input)
{
  const std::string name = fs::path(input).stem().string() + endingOf(settings.format);
  return (fs::path(settings.folder) / name).string();
}

/** How bad an outcome is; the codes themselves are not in that order. */
int
badness(ExitCode code)
{
  switch (code) {
  case DONE:
    return 0;
  case INCOMPLETE:
    return 1;
  case BAD_INPUT:
    return 2;
  case INTERRUPTED:
    break;
  }
  return 3;
}

/** \brief Counts outcomes. */
struct Totals {
  std::size_t done = 0;
  std::size_t incomplete = 0;
  std::size_t failed = 0;
  ExitCode worst = app::DONE;

  void
  add(ExitCode code)
  {
    done += code == DONE ? 1 : 0;
    incomplete += code == INCOMPLETE ? 1 : 0;
    failed += code == BAD_INPUT ? 1 : 0;
    if (badness(code) > badness(worst))
      worst = code;
  }

  std::string
  text(std::size_t inputs) const
  {
    return plural(inputs, "input") + ": " + std::to_string(done) + " done, " +
           std::to_string(incomplete) + " with something left undone, " +
           std::to_string(failed) + " failed";
  }
};

Status
writeBatchReport(const BatchSettings& settings,
                 const Totals& totals,
                 double seconds,
                 json files)
{
  if (settings.report.empty())
    return {};
  json report = {{"program", settings.program},
                 {"version", version()},
                 {"output", settings.folder},
                 {"exit_code", totals.worst},
                 {"complete", totals.worst == DONE},
                 {"seconds", seconds},
                 {"files", std::move(files)}};
  OutputFile file;
  const Status status = file.open(settings.report);
  if (!status.ok())
    return status;
  writeReport(report, file);
  return file.commit();
}

/** The report of an input, whatever became of it. */
json
finished(const BatchSettings& settings,
         const BatchItem& item,
         const Outcome& outcome,
         json report)
{
  if (outcome.code == BAD_INPUT || report.is_null()) {
    report = json::object();
    addRunFacts({settings.program, item.input, "", outcome.code, 0, {}}, report);
  }
  if (outcome.code != DONE)
    report["reason"] = outcome.reason;
  return report;
}

/** The outputs, when all of them can be written. */
Status
planBatch(const BatchSettings& settings, std::vector<BatchItem>& items)
{
  std::map<std::string, std::string> input_of;
  std::vector<std::string> outputs{settings.report};
  for (const std::string& input : settings.inputs) {
    if (isStandardStream(input))
      return Status::error("standard input ('-') has no name to give to an output in a "
                           "folder");
    const std::string output = outputFor(settings, input);
    const auto [other, is_new] = input_of.emplace(output, input);
    if (!is_new)
      return Status::error("'" + other->second + "' and '" + input +
                           "' would both become '" + output + "'");
    items.push_back({input, output});
    outputs.push_back(output);
  }
  Status status = checkDifferentFiles(settings.inputs, outputs);
  for (const BatchItem& item : items)
    if (status.ok())
      status = checkReplaceable(item.output);
  if (status.ok() && settings.writes)
    status = OutputFolder::check(settings.folder);
  if (status.ok() && !settings.report.empty() &&
      !(settings.writes && OutputFolder::bringsAlong(settings.folder, settings.report)))
    status = OutputFile::check(settings.report);
  return status;
}

} // namespace

Outcome
runBatch(const BatchSettings& settings, const BatchWork& work)
{
  std::vector<BatchItem> items;
  Status status = planBatch(settings, items);
  // Takes the folder away again if no output came to lie in it.
  OutputFolder folder;
  if (status.ok() && settings.writes)
    status = folder.open(settings.folder);
  if (!status.ok())
    return Outcome::badInput(status);
  Stopwatch watch;
  Totals totals;
  json files = json::array();
  for (const BatchItem& item : items) {
    json report;
    const Outcome outcome = runGuarded([&] { return work(item, report); });
    if (interrupted() || outcome.code == INTERRUPTED)
      return {INTERRUPTED,
              "stopped by a signal; of " + plural(items.size(), "input") + " " +
                  std::to_string(files.size()) + " had been worked on to the end",
              {}};
    const bool names_input = outcome.reason.find(item.input) != std::string::npos;
    tellOutcome(settings.program + (names_input ? "" : ": " + item.input),
                outcome,
                settings.quiet);
    totals.add(outcome.code);
    files.push_back(finished(settings, item, outcome, std::move(report)));
  }
  status = writeBatchReport(settings, totals, watch.lap(), std::move(files));
  if (!status.ok())
    return Outcome::badInput(status);
  const std::string text = totals.text(items.size());
  return {totals.worst, text, {}, {text, &peopleStream({settings.report})}};
}

} // namespace app
