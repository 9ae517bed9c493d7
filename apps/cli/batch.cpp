// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one program run over many inputs.
#include "batch.h"

#include "io/interrupt.h"
#include "io/output_folder.h"
#include "io/overwriting.h"
#include "io/wording.h"
#include "run_facts.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/** \brief Counts outcomes. */
struct Totals {
  std::map<ExitCode, std::size_t> counts;

  /** Of what came up the worst, which is not the greatest code. */
  ExitCode
  worst() const
  {
    for (const ExitCode code : {BAD_INPUT, INCOMPLETE})
      if (counts.count(code) != 0)
        return code;
    return DONE;
  }

  std::string
  text(std::size_t inputs)
  {
    return plural(inputs, "input") + ": " + std::to_string(counts[DONE]) + " done, " +
           std::to_string(counts[INCOMPLETE]) + " with something left undone, " +
           std::to_string(counts[BAD_INPUT]) + " failed";
  }
};

void
writeBatchReport(const Batch& batch, ExitCode code, double seconds, json files)
{
  if (batch.files.report.empty())
    return;
  const json report = {{"program", batch.program},
                       {"version", version()},
                       {"output", batch.files.folder},
                       {"exit_code", code},
                       {"complete", code == DONE},
                       {"seconds", seconds},
                       {"files", std::move(files)}};
  OutputFile file;
  require(file.open(batch.files.report));
  writeReport(report, file);
  require(file.commit());
}

/** The report of an input, whatever became of it. */
json
finished(const Batch& batch,
         const std::string& input,
         const Outcome& outcome,
         json report)
{
  if (outcome.code == BAD_INPUT || report.is_null()) {
    report = json::object();
    addRunFacts({batch.program, input, "", outcome.code, 0}, {}, report);
  }
  if (outcome.code != DONE)
    report["reason"] = outcome.reason;
  return report;
}

/** The names of each input and its output, when all of these can be written. */
std::vector<FileNames>
planBatch(const Batch& batch)
{
  const FileNames& all = batch.files;
  std::map<std::string, std::string> input_of;
  std::vector<FileNames> items;
  std::vector<std::string> outputs{all.report};
  for (const std::string& input : all.inputs) {
    if (isStandardStream(input))
      throw Failure(
          "standard input ('-') has no name to give to an output in a folder");
    const fs::path name = fs::path(input).stem().string() + endingOf(all.format);
    const std::string output = (fs::path(all.folder) / name).string();
    const auto [other, is_new] = input_of.emplace(output, input);
    if (!is_new)
      throw Failure("'" + other->second + "' and '" + input + "' would both become '" +
                    output + "'");
    items.push_back({{input}, output, all.folder, all.report, all.format});
    outputs.push_back(output);
  }
  checkDifferentFiles(all.inputs, outputs);
  for (const FileNames& item : items)
    require(checkReplaceable(item.output));
  if (batch.writes)
    require(OutputFolder::check(all.folder));
  if (!all.report.empty() &&
      !(batch.writes && OutputFolder::bringsAlong(all.folder, all.report)))
    require(OutputFile::check(all.report));
  return items;
}

} // namespace

Outcome
runBatch(const Batch& batch, const BatchWork& work)
{
  const std::vector<FileNames> items = planBatch(batch);
  // Takes the folder away again if no output came to lie in it.
  OutputFolder folder;
  if (batch.writes)
    require(folder.open(batch.files.folder));
  Stopwatch watch;
  Totals totals;
  json files = json::array();
  for (const FileNames& item : items) {
    json report;
    const Outcome outcome = runGuarded([&] { return work(item, report); });
    if (interrupted() || outcome.code == INTERRUPTED)
      return {INTERRUPTED,
              "stopped by a signal; of " + plural(items.size(), "input") + " " +
                  std::to_string(files.size()) + " had been worked on to the end",
              {}};
    const bool names_input = outcome.reason.find(item.input()) != std::string::npos;
    tellOutcome(
        batch.program + (names_input ? "" : ": " + item.input()), outcome, batch.quiet);
    ++totals.counts[outcome.code];
    files.push_back(finished(batch, item.input(), outcome, std::move(report)));
  }
  const ExitCode code = totals.worst();
  writeBatchReport(batch, code, watch.lap(), std::move(files));
  const std::string text = totals.text(items.size());
  return {code, text, {}, {text, &peopleStream({batch.files.report})}};
}

} // namespace app
