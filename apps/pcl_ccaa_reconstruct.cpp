// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include "cli/batch.h"
#include "cli/reconstruct_options.h"
#include "io/merge.h"
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
void
checkFiles(const app::FileNames& files)
{
  app::require(app::checkDifferentFiles(files.inputs, {files.output, files.report}));
  if (!files.output.empty())
    app::require(app::checkMeshOutput(files.target()));
  if (!files.report.empty())
    app::require(app::OutputFile::check(files.report));
}

void
readInput(const app::ReconstructSettings& settings, app::Model& model)
{
  std::vector<app::NamedModel> parts;
  for (const std::string& input : settings.files.inputs) {
    parts.push_back({input, {}});
    app::require(app::readCloud(input, parts.back().model));
  }
  app::require(app::mergeModels(parts, model));
  if (!settings.dry_run)
    app::require(app::checkCoordinates(settings.files.target(), model));
  app::noteShift(model);
  app::require(app::requireTrianglePoints(model.mesh.cloud, settings.inputName()));
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
                    settings.files.input(),
                    settings.dry_run ? "" : settings.files.output,
                    outcome.code,
                    seconds,
                    result.model.remarks,
                    result.model.shift},
                   report);
  if (settings.merge)
    report["input"] = settings.files.inputs;
  return report;
}

void
writeOutputs(const app::ReconstructSettings& settings,
             const app::Outcome& outcome,
             app::ReconstructResult& result)
{
  app::Model& model = result.model;
  app::OutputFolder folder;
  if (!settings.dry_run)
    app::writeMesh(settings.files.target(),
                   model.mesh,
                   {faceProperties(settings, result), model.viewpoint, model.remarks},
                   folder.addElsewhere(settings.files.output),
                   model.warnings);
  // Of many inputs there is one report, at the end.
  if (!settings.files.report.empty() && !settings.files.isBatch())
    app::writeReport(describe(settings, outcome, result),
                     folder.addElsewhere(settings.files.report));
  app::require(folder.commit());
}

std::ostream&
peopleStreamOf(const app::FileNames& files)
{
  return app::peopleStream({files.output, files.report});
}

void
sumUp(const app::ReconstructSettings& settings, const app::ReconstructResult& result)
{
  std::ostream& people = peopleStreamOf(settings.files);
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
void
work(const app::ReconstructSettings& settings,
     app::ProgressBar& bar,
     app::ReconstructResult& result)
{
  result.memory_before = app::currentMemoryBytes();
  if (bar.show("start", 0))
    app::require(app::runReconstruction(settings, bar, result));
  if (bar.show("normals", 0))
    app::addNormals(result);
  if (settings.repair && bar.show("repair", 0))
    app::require(app::repairResult(settings, bar, result));
  if (result.chain.skipped_points > 0)
    result.model.warnings.push_back(
        app::pluralHas(result.chain.skipped_points, "point") +
        " coordinates that are not finite, and no triangle");
}

/** \brief One mesh, from its file or files to all that is written. */
app::Outcome
runOne(const app::ReconstructSettings& settings, app::ReconstructResult& result)
{
  app::ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  readInput(settings, result.model);
  if (!settings.dry_run)
    work(settings, bar, result);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  app::Outcome outcome = settings.dry_run ? app::Outcome() : judge(result);
  writeOutputs(settings, outcome, result);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.model.warnings;
  outcome.verdict = {tellVerdict(settings, result), &peopleStreamOf(settings.files)};
  return outcome;
}

app::Outcome
run(const app::ReconstructSettings& settings)
{
  if (!settings.files.isBatch()) {
    app::ReconstructResult result;
    checkFiles(settings.files);
    return runOne(settings, result);
  }
  const auto work = [&](const app::FileNames& files, nlohmann::json& report) {
    app::ReconstructSettings one = settings;
    one.files = files;
    app::ReconstructResult result;
    const app::Outcome outcome = runOne(one, result);
    if (outcome.succeeded())
      report = describe(one, outcome, result);
    return outcome;
  };
  return app::runBatch(
      {"pcl_ccaa_reconstruct", settings.files, settings.quiet, !settings.dry_run},
      work);
}

} // namespace

int
main(int argc, char** argv)
{
  app::ReconstructSettings settings;
  app::CommandLine line(app::reconstructUsage(), settings.quiet);
  app::addReconstructOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return run(settings); });
}
