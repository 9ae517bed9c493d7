// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include "cli/batch.h"
#include "cli/cli.h"
#include "cli/reconstruct_options.h"
#include "cli/reconstruct_run.h"
#include "io/merge.h"
#include "io/model_io.h"
#include "io/output_folder.h"
#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "report/hole_report.h"
#include "report/reconstruct_report.h"
#include "report/verdict.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace {

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::ReconstructSettings& settings)
{
  app::Status status =
      app::checkDifferentFiles(settings.inputs, {settings.output, settings.report});
  if (status.ok() && !settings.output.empty())
    status = app::checkMeshOutput(settings.target());
  if (status.ok() && !settings.report.empty())
    status = app::OutputFile::check(settings.report);
  return status;
}

app::Status
readInput(const app::ReconstructSettings& settings, app::ReconstructResult& result)
{
  std::vector<app::NamedModel> parts;
  for (const std::string& input : settings.inputs) {
    parts.push_back({input, {}});
    const app::Status status = app::readCloud(input, parts.back().model);
    if (!status.ok())
      return status;
  }
  app::Status status = app::mergeModels(parts, result.model);
  if (status.ok() && !settings.dry_run)
    status = app::checkCoordinates(settings.target(), result.model);
  if (!status.ok())
    return status;
  app::noteShift(result.model);
  return app::requireTrianglePoints(result.model.mesh.cloud, settings.inputName());
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
    return {app::INCOMPLETE,
            app::pluralIs(result.filter.one_sided_components, "region") +
                " one-sided (like a Moebius band) and could not be oriented",
            {}};
  if (result.repair && !result.repair->complete())
    return {
        app::INCOMPLETE, app::tellShortfalls(*result.repair, result.model.mesh), {}};
  return {app::DONE, "", {}};
}

nlohmann::json
describe(const app::ReconstructSettings& settings,
         const app::Outcome& outcome,
         const app::ReconstructResult& result)
{
  nlohmann::json report =
      settings.dry_run ? app::describeInput(settings, result.model)
                       : app::describeRun(settings, result, result.model.warnings);
  const double seconds = settings.dry_run ? 0.0 : double{report["total_seconds"]};
  app::addRunFacts({"pcl_ccaa_reconstruct",
                    settings.input,
                    settings.dry_run ? "" : settings.output,
                    outcome.code,
                    seconds,
                    result.model.remarks,
                    result.model.shift},
                   report);
  if (settings.merge)
    report["input"] = settings.inputs;
  return report;
}

app::Status
writeOutputs(const app::ReconstructSettings& settings,
             const app::Outcome& outcome,
             app::ReconstructResult& result)
{
  app::Model& model = result.model;
  app::OutputFolder files;
  if (!settings.dry_run)
    app::writeMesh(settings.target(),
                   model.mesh,
                   {faceProperties(settings, result), model.viewpoint, model.remarks},
                   files.addElsewhere(settings.output),
                   model.warnings);
  // Of many inputs there is one report, at the end.
  if (!settings.report.empty() && settings.output_folder.empty())
    app::writeReport(describe(settings, outcome, result),
                     files.addElsewhere(settings.report));
  return files.commit();
}

void
sumUp(const app::ReconstructSettings& settings, const app::ReconstructResult& result)
{
  std::ostream& people = app::peopleStream({settings.output, settings.report});
  people << (settings.dry_run ? app::summarizeInput(settings, result.model)
                              : app::summarizeRun(settings, result))
         << std::endl;
  if (result.speedup)
    people << app::tabulateSpeedup(*result.speedup) << std::endl;
}

std::string
tellVerdict(const app::ReconstructSettings& settings,
            const app::ReconstructResult& result)
{
  if (settings.dry_run)
    return app::plural(app::pointCount(result.model.mesh.cloud), "point") +
           " to reconstruct";
  if (!settings.hasFilter())
    return "raw triangles";
  app::SurfaceFacts facts;
  if (result.repair)
    facts = app::surfaceFacts(*result.repair);
  else
    facts.open = result.topology ? result.topology->boundary_loops : 0;
  facts.has_triangles = !result.model.mesh.polygons.empty();
  facts.faults += result.filter.one_sided_components;
  return app::tellSurface(facts);
}

/** \brief From the cloud that was read to the mesh. */
app::Status
work(const app::ReconstructSettings& settings,
     app::ProgressBar& bar,
     app::ReconstructResult& result)
{
  result.memory_before = app::currentMemoryBytes();
  app::Status status;
  if (bar.show("start", 0))
    status = app::runReconstruction(settings, bar, result);
  if (status.ok() && bar.show("normals", 0))
    app::addNormals(result);
  if (status.ok() && settings.repair && bar.show("repair", 0))
    status = app::repairResult(settings, bar, result);
  if (result.chain.skipped_points > 0)
    result.model.warnings.push_back(
        app::pluralHas(result.chain.skipped_points, "point") +
        " coordinates that are not finite, and no triangle");
  return status;
}

/** \brief One mesh, from its file or files to all that is written. */
app::Outcome
runOne(const app::ReconstructSettings& settings, app::ReconstructResult& result)
{
  app::ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  app::Status status = readInput(settings, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (!settings.dry_run)
    status = work(settings, bar, result);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  if (!status.ok())
    return app::Outcome::badInput(status);
  app::Outcome outcome = settings.dry_run ? app::Outcome() : judge(result);
  status = writeOutputs(settings, outcome, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.model.warnings;
  outcome.verdict = {tellVerdict(settings, result),
                     &app::peopleStream({settings.output, settings.report})};
  return outcome;
}

/** \brief A mesh of each input, with one report about them. */
app::Outcome
runMany(const app::ReconstructSettings& settings)
{
  const app::BatchSettings batch{"pcl_ccaa_reconstruct",
                                 settings.inputs,
                                 settings.output_folder,
                                 settings.report,
                                 settings.format,
                                 settings.quiet,
                                 !settings.dry_run};
  return app::runBatch(batch, [&](const app::BatchItem& item, nlohmann::json& report) {
    app::ReconstructSettings one = settings;
    one.input = item.input;
    one.inputs = {item.input};
    one.output = item.output;
    app::ReconstructResult result;
    app::Outcome outcome = runOne(one, result);
    if (outcome.code == app::DONE || outcome.code == app::INCOMPLETE)
      report = describe(one, outcome, result);
    return outcome;
  });
}

app::Outcome
reconstruct(const app::Arguments& arguments)
{
  app::ReconstructSettings settings;
  app::ReconstructResult result;
  app::Status status = app::takeReconstructSettings(arguments, settings);
  if (status.ok() && !settings.output_folder.empty())
    return runMany(settings);
  if (status.ok())
    status = checkFiles(settings);
  return status.ok() ? runOne(settings, result) : app::Outcome::badInput(status);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(app::makeReconstructCommandLine(), argc, argv, reconstruct);
}
