// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include "common/cli.h"
#include "common/hole_report.h"
#include "common/model_io.h"
#include "common/position_check.h"
#include "common/reconstruct_options.h"
#include "common/reconstruct_report.h"
#include "common/reconstruct_run.h"
#include <nlohmann/json.hpp>

#include <iostream>

namespace {

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::ReconstructSettings& settings)
{
  app::Status status =
      app::checkDifferentFiles({settings.input, settings.output, settings.report});
  if (status.ok())
    status = app::checkMeshOutput(settings.output);
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
    return app::Status::error("'" + settings.input + "' has only " +
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

app::Status
writeOutputs(const app::ReconstructSettings& settings,
             const app::ReconstructResult& result,
             app::Warnings& warnings)
{
  app::OutputFile mesh;
  app::OutputFile report;
  app::Status status = mesh.open(settings.output);
  if (status.ok())
    app::writeMesh(settings.output,
                   result.model.mesh,
                   faceProperties(settings, result),
                   mesh,
                   warnings);
  if (status.ok() && !settings.report.empty()) {
    status = report.open(settings.report);
    if (status.ok())
      app::writeReport(app::describeRun(settings, result, warnings), report);
  }
  if (status.ok())
    status = mesh.commit();
  if (status.ok() && !settings.report.empty())
    status = report.commit();
  return status;
}

app::Outcome
judge(const app::ReconstructResult& result)
{
  if (result.model.mesh.polygons.empty())
    return {
        app::INCOMPLETE,
        "no triangle could be made that is sure to be right (too few points, or all "
        "on a line?); the output holds the points alone",
        result.model.warnings};
  if (result.filter.one_sided_components > 0)
    return {
        app::INCOMPLETE,
        std::to_string(result.filter.one_sided_components) +
            " regions are one-sided (like a Moebius band) and could not be oriented",
        result.model.warnings};
  if (result.repair && !result.repair->complete())
    return {app::INCOMPLETE,
            app::tellShortfalls(*result.repair, result.model.mesh),
            result.model.warnings};
  return {app::DONE, "", result.model.warnings};
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
    return {app::INTERRUPTED, "stopped by a signal; nothing was written", {}};
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (result.chain.skipped_points > 0)
    result.model.warnings.push_back(
        std::to_string(result.chain.skipped_points) +
        " points have coordinates that are not finite; they stay without triangles");
  status = writeOutputs(settings, result, result.model.warnings);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  if (!settings.quiet)
    std::cout << app::summarizeRun(settings, result) << std::endl;
  if (!settings.quiet && result.speedup)
    std::cout << app::tabulateSpeedup(*result.speedup) << std::endl;
  return judge(result);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(app::makeReconstructCommandLine(), argc, argv, reconstruct);
}
