// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include "common/cli.h"
#include "common/hole_report.h"
#include "common/model_io.h"
#include "common/output_folder.h"
#include "common/position_check.h"
#include "common/reconstruct_options.h"
#include "common/reconstruct_report.h"
#include "common/reconstruct_run.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace {

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::ReconstructSettings& settings)
{
  app::Status status =
      app::checkDifferentFiles({settings.input}, {settings.output, settings.report});
  if (status.ok())
    status = app::checkMeshOutput(settings.target());
  if (status.ok() && !settings.report.empty())
    status = app::OutputFile::check(settings.report);
  return status;
}

app::Status
readInput(const app::ReconstructSettings& settings, app::ReconstructResult& result)
{
  app::Status status = app::readCloud(settings.input, result.model);
  if (!status.ok())
    return status;
  const std::size_t usable = app::countUsablePoints(result.model.mesh.cloud, 3);
  if (usable < 3)
    return app::Status::error(app::nameForPeople(settings.input) + " has only " +
                              std::to_string(usable) +
                              " usable points (finite, at different places); at least "
                              "three are needed");
  return {};
}

/** Triangles with what is to be told about each. */
std::vector<app::FaceProperty>
faceProperties(const app::ReconstructSettings& settings,
               const app::ReconstructResult& result)
{
  if (!settings.labels)
    return {};
  return {{"stage", {result.labels.begin(), result.labels.end()}}};
}

app::Outcome
judge(const app::ReconstructResult& result)
{
  if (result.model.mesh.polygons.empty())
    return {
        app::INCOMPLETE,
        "no triangle could be made that is sure to be right (too few points, or all "
        "on a line?); the output holds the points alone",
        {}};
  if (result.filter.one_sided_components > 0)
    return {
        app::INCOMPLETE,
        std::to_string(result.filter.one_sided_components) +
            " regions are one-sided (like a Moebius band) and could not be oriented",
        {}};
  if (result.repair && !result.repair->complete())
    return {
        app::INCOMPLETE, app::tellShortfalls(*result.repair, result.model.mesh), {}};
  return {app::DONE, "", {}};
}

app::Status
writeOutputs(const app::ReconstructSettings& settings,
             const app::Outcome& outcome,
             app::ReconstructResult& result)
{
  app::Model& model = result.model;
  app::OutputFolder files;
  app::writeMesh(settings.target(),
                 model.mesh,
                 {faceProperties(settings, result), model.viewpoint, model.remarks},
                 files.addElsewhere(settings.output),
                 model.warnings);
  if (!settings.report.empty()) {
    nlohmann::json report = app::describeRun(settings, result, model.warnings);
    app::addRunFacts({"pcl_ccaa_reconstruct",
                      settings.input,
                      settings.output,
                      outcome.code,
                      report["total_seconds"],
                      model.remarks},
                     report);
    app::writeReport(report, files.addElsewhere(settings.report));
  }
  return files.commit();
}

app::Outcome
reconstruct(const app::Arguments& arguments)
{
  app::ReconstructSettings settings;
  app::ReconstructResult result;
  app::Status status = app::takeReconstructSettings(arguments, settings);
  if (status.ok())
    status = checkFiles(settings);
  app::ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  if (status.ok())
    status = readInput(settings, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  result.memory_before = app::currentMemoryBytes();
  if (bar.show("start", 0))
    status = app::runReconstruction(settings, bar, result);
  if (status.ok() && bar.show("normals", 0))
    app::addNormals(result);
  if (status.ok() && settings.repair && bar.show("repair", 0))
    status = app::repairResult(settings, bar, result);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (result.chain.skipped_points > 0)
    result.model.warnings.push_back(
        std::to_string(result.chain.skipped_points) +
        " points have coordinates that are not finite; they stay without triangles");
  app::Outcome outcome = judge(result);
  status = writeOutputs(settings, outcome, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  std::ostream& people = app::peopleStream({settings.output, settings.report});
  if (!settings.quiet)
    people << app::summarizeRun(settings, result) << std::endl;
  if (!settings.quiet && result.speedup)
    people << app::tabulateSpeedup(*result.speedup) << std::endl;
  outcome.notes = result.model.warnings;
  return outcome;
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(app::makeReconstructCommandLine(), argc, argv, reconstruct);
}
