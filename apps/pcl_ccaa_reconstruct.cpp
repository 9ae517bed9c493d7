// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include "cli/batch.h"
#include "cli/reconstruct_options.h"
#include "io/merge.h"
#include "io/output_folder.h"
#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "out_of_core/tiled_reconstruction.h"
#include "report/hole_report.h"
#include "report/reconstruct_report.h"
#include "report/reconstruct_verdict.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace app {
namespace {

/** All that can be known to fail before the work begins. */
void
checkFiles(const FileNames& files)
{
  checkDifferentFiles(files.inputs, {files.output, files.report});
  if (!files.output.empty())
    require(checkMeshOutput(files.target()));
  if (!files.report.empty())
    require(OutputFile::check(files.report));
}

void
readInput(const ReconstructSettings& settings, Model& model)
{
  std::vector<NamedModel> parts;
  for (const std::string& input : settings.files.inputs) {
    parts.push_back({input, {}});
    require(readCloud(input, parts.back().model));
  }
  mergeModels(parts, model);
  if (!settings.dry_run)
    checkCoordinates(settings.files.target(), model);
  noteShift(model);
  requireTrianglePoints(model.mesh.cloud, settings.inputName());
}

/** Triangles with what is to be told about each. */
std::vector<FaceProperty>
faceProperties(const ReconstructSettings& settings, const ReconstructResult& result)
{
  if (!settings.labels)
    return {};
  return {{"stage", {result.labels.begin(), result.labels.end()}}};
}

nlohmann::json
describe(const ReconstructSettings& settings,
         const Outcome& outcome,
         const ReconstructResult& result)
{
  nlohmann::json report = settings.dry_run
                              ? describeInput(settings, result.model)
                              : describeRun(settings, result, result.model.warnings);
  const double seconds = settings.dry_run ? 0.0 : double{report["total_seconds"]};
  addRunFacts({"pcl_ccaa_reconstruct",
               settings.files.input(),
               settings.dry_run ? "" : settings.files.output,
               outcome.code,
               seconds},
              result.model,
              report);
  if (settings.merge)
    report["input"] = settings.files.inputs;
  return report;
}

void
writeOutputs(const ReconstructSettings& settings,
             const Outcome& outcome,
             ReconstructResult& result)
{
  Model& model = result.model;
  OutputFolder folder;
  if (!settings.dry_run)
    writeMesh(settings.files.target(),
              model.mesh,
              {faceProperties(settings, result), model.viewpoint, model.remarks},
              folder.addElsewhere(settings.files.output),
              model.warnings);
  // Of many inputs there is one report, at the end.
  if (!settings.files.report.empty() && !settings.files.isBatch())
    writeReport(describe(settings, outcome, result),
                folder.addElsewhere(settings.files.report));
  require(folder.commit());
}

std::ostream&
peopleStreamOf(const FileNames& files)
{
  return peopleStream({files.output, files.report});
}

void
sumUp(const ReconstructSettings& settings, const ReconstructResult& result)
{
  std::ostream& people = peopleStreamOf(settings.files);
  if (result.cleaning)
    people << tellCleaning(*result.cleaning) << std::endl;
  people << (settings.dry_run ? summarizeInput(settings, result.model)
                              : summarizeRun(settings, result))
         << std::endl;
  if (result.speedup)
    people << tabulateSpeedup(*result.speedup) << std::endl;
}

/** \brief From the cloud that was read to the mesh. */
void
work(const ReconstructSettings& settings, ProgressBar& bar, ReconstructResult& result)
{
  result.memory_before = currentMemoryBytes();
  if (settings.clean)
    cleanInput(settings, bar, result);
  if (bar.show("start", 0))
    runReconstruction(settings, bar.callback(), result);
  countTopology(settings, result);
  if (bar.show("normals", 0))
    addNormals(result);
  if (settings.repair && bar.show("repair", 0))
    repairResult(settings, bar, result);
  if (result.chain.skipped_points > 0)
    result.model.warnings.push_back(
        pluralHas(result.chain.skipped_points, "point") +
        " coordinates that are not finite, and no triangle");
}

/** \brief One mesh, from its file or files to all that is written. */
Outcome
runOne(const ReconstructSettings& settings, ReconstructResult& result)
{
  ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  readInput(settings, result.model);
  if (!settings.dry_run)
    work(settings, bar, result);
  if (!bar.show("writing", 0))
    return {INTERRUPTED, stopped_by_signal, {}};
  Outcome outcome;
  if (!settings.dry_run) {
    outcome.reason = tellIncomplete(settings, result);
    if (const std::string advice = adviceFor(settings, result);
        outcome.reason.empty() && !advice.empty())
      result.model.warnings.push_back(advice);
  }
  outcome.code = outcome.reason.empty() ? DONE : INCOMPLETE;
  writeOutputs(settings, outcome, result);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.model.warnings;
  outcome.verdict = {tellVerdict(settings, result), &peopleStreamOf(settings.files)};
  return outcome;
}

Outcome
run(const ReconstructSettings& settings)
{
  if (settings.tiles > 0) {
    checkFiles(settings.files);
    return reconstructInTiles(settings);
  }
  if (!settings.files.isBatch()) {
    ReconstructResult result;
    checkFiles(settings.files);
    return runOne(settings, result);
  }
  const auto work = [&](const FileNames& files, nlohmann::json& report) {
    ReconstructSettings one = settings;
    one.files = files;
    ReconstructResult result;
    const Outcome outcome = runOne(one, result);
    if (outcome.succeeded())
      report = describe(one, outcome, result);
    return outcome;
  };
  return runBatch(
      {"pcl_ccaa_reconstruct", settings.files, settings.quiet, !settings.dry_run},
      work);
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::ReconstructSettings settings;
  app::CommandLine line(app::reconstructUsage(), settings.quiet);
  app::addReconstructOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return app::run(settings); });
}
