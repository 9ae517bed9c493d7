// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that repairs an incomplete model, or shows what it
// lacks.
#include "cli/batch.h"
#include "cli/repair_options.h"
#include "cli/repair_run.h"
#include "cli/run_facts.h"
#include "inspect/bridge_layer.h"
#include "inspect/inspection_files.h"
#include "io/overwriting.h"
#include "io/position_check.h"
#include "io/writers.h"
#include "render/display.h"
#include "render/inspection_pictures.h"
#include "render/render_options.h"
#include "repair/decision_proposal.h"
#include "report/dry_run.h"
#include "report/hole_report.h"
#include "report/repair_report.h"
#include "report/verdict.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace {

/** \brief What was found and done, in all the forms it is handed out. */
struct Result {
  app::Model model; /**< as it was read; repaired when that is asked for */
  app::Model free_points;
  pcl::RepairReport repair;
  pcl::repair::ModelSurvey survey;
  pcl::repair::FieldSlice slice;
  std::vector<app::InspectionLayer> layers;
  std::vector<app::InspectionPicture> pictures;
  app::Warnings warnings;
};

/** All that can be known to fail before the work begins. */
void
checkFiles(const app::RepairSettings& settings)
{
  const app::FileNames& names = settings.files;
  const std::string decisions = settings.dry_run ? settings.decisions : "";
  std::vector<std::string> files{
      names.output, settings.bridges, names.report, settings.inspect, decisions};
  if (!settings.inspect.empty())
    for (const std::string& name : app::inspectionNames())
      files.push_back(settings.inspect + "/" + name);
  app::require(app::checkDifferentFiles({names.input(), settings.free_points}, files));
  for (const std::string& file : files)
    app::require(app::checkReplaceable(file));
  if (!names.output.empty())
    app::require(app::checkMeshOutput(names.target()));
  for (const std::string& file : {settings.bridges, decisions})
    if (!file.empty())
      app::require(app::OutputFile::check(file));
  if (!settings.inspect.empty())
    app::require(app::OutputFolder::check(settings.inspect));
  if (!names.report.empty() &&
      !app::OutputFolder::bringsAlong(settings.inspect, names.report))
    app::require(app::OutputFile::check(names.report));
}

void
readInput(const app::RepairSettings& settings, Result& result)
{
  app::require(app::readMesh(settings.files.input(), result.model));
  if (!settings.free_points.empty())
    app::require(app::readCloud(settings.free_points, result.free_points));
  if (settings.repairs())
    app::require(app::checkCoordinates(settings.files.target(), result.model));
  app::noteShift(result.model);
  result.warnings = result.model.warnings;
  for (const std::string& warning : result.free_points.warnings)
    result.warnings.push_back("free points: " + warning);
}

app::RepairTask
taskOf(const app::RepairSettings& settings, const Result& result)
{
  return {settings.method,
          settings.free_points.empty() ? nullptr : &result.free_points.mesh.cloud,
          settings.threads};
}

[[noreturn]] void
failAbout(const app::RepairSettings& settings, const std::string& problem)
{
  throw app::Failure(app::nameForPeople(settings.files.input()) + ": " + problem);
}

/** \brief Find all that can be told about the model. */
void
survey(const app::RepairSettings& settings, app::ProgressBar& bar, Result& result)
{
  app::RepairTask task = taskOf(settings, result);
  task.method.survey = settings.surveyParameters();
  result.survey = app::surveyMesh(task,
                                  result.model.viewpoint,
                                  bar,
                                  result.model.mesh,
                                  settings.inspect.empty() ? nullptr : &result.slice);
  if (!result.survey.reading.problem.empty())
    failAbout(settings, result.survey.reading.problem);
}

void
repair(const app::RepairSettings& settings, app::ProgressBar& bar, Result& result)
{
  const app::Status status = app::repairMesh(taskOf(settings, result),
                                             result.model.viewpoint,
                                             bar,
                                             result.model.mesh,
                                             result.repair);
  if (!status.ok())
    failAbout(settings, status.message());
}

void
makeLayers(Result& result)
{
  const auto& survey = result.survey;
  result.layers = {app::showLoops(survey),
                   app::showIslands(survey),
                   app::showLines(survey),
                   app::showLineNormals(survey),
                   app::showLinePoints(survey),
                   app::showOrigins(survey),
                   app::showFreePoints(survey),
                   app::showSlice(result.slice),
                   app::showSection(survey, result.slice)};
}

/** \brief Draw the pictures, or say why there are none. */
void
drawPictures(const app::InspectionView& view, Result& result)
{
  const app::Display display;
  if (display.ready())
    result.pictures = drawInspection(result.survey, result.slice, result.layers, view);
  else
    result.warnings.push_back("no X display to draw with, so pictures were left out: "
                              "set DISPLAY or install Xvfb");
}

/** \brief How the run ends if the files can be written. */
app::Outcome
judge(const app::RepairSettings& settings, const Result& result)
{
  if (settings.dry_run) {
    const app::RepairPlan plan = app::planRepair(result.survey, settings.method);
    return plan.isEmpty() ? app::Outcome()
                          : app::Outcome{app::INCOMPLETE, app::summarizePlan(plan), {}};
  }
  if (settings.repairs() && !result.repair.complete())
    return {app::INCOMPLETE, app::tellShortfalls(result.repair, result.model.mesh), {}};
  return {};
}

nlohmann::json
describe(const app::RepairSettings& settings,
         const app::Outcome& outcome,
         const Result& result)
{
  nlohmann::json report =
      settings.repairs()
          ? app::describeRun(settings, result.repair, result.warnings)
          : app::describeSurvey(settings, result.survey, result.warnings);
  if (settings.dry_run)
    app::describePlan(settings, result.survey, report);
  if (settings.repairs() && settings.surveys())
    report["survey"] = app::describeSurvey(settings, result.survey, {});
  const double seconds = report[settings.repairs() ? "seconds" : "total_seconds"];
  app::addRunFacts({"pcl_repair_holes",
                    settings.files.input(),
                    settings.repairs() ? settings.files.output : "",
                    outcome.code,
                    seconds,
                    result.model.remarks,
                    result.model.shift},
                   report);
  return report;
}

void
writeBridges(const std::string& path, const Result& result, app::OutputFolder& folder)
{
  const pcl::GlobalShift& shift = result.model.shift;
  auto layer = app::showBridges(result.repair.bridges, shift);
  if (!shift.isNone())
    shift.toGlobal(pcl::PCLPointCloud2(layer.cloud), layer.cloud);
  app::writeVtkLines(layer.cloud, layer.lines, folder.addElsewhere(path));
}

/** \brief All files appear together or not at all. */
void
writeOutputs(const app::RepairSettings& settings,
             const app::Outcome& outcome,
             Result& result)
{
  const app::FileNames& files = settings.files;
  app::OutputFolder folder;
  if (!settings.inspect.empty()) {
    app::require(folder.open(settings.inspect));
    writeInspection(result.layers, result.pictures, result.model.shift, folder);
  }
  if (settings.repairs()) {
    app::FileExtras extras{{}, result.model.viewpoint, result.model.remarks};
    if (settings.labels)
      extras.properties.push_back(app::originProperty(result.repair));
    app::writeMesh(files.target(),
                   result.model.mesh,
                   extras,
                   folder.addElsewhere(files.output),
                   result.warnings);
  }
  if (!settings.bridges.empty())
    writeBridges(settings.bridges, result, folder);
  if (settings.dry_run && !settings.decisions.empty())
    app::writeDecisions(files.input(),
                        proposeDecisions(result.survey, settings.method),
                        folder.addElsewhere(settings.decisions));
  // Of many inputs there is one report, at the end.
  if (!files.report.empty() && !files.isBatch())
    app::writeReport(describe(settings, outcome, result),
                     folder.addElsewhere(files.report));
  app::require(folder.commit());
}

std::ostream&
peopleStreamOf(const app::RepairSettings& settings)
{
  return app::peopleStream({settings.files.output,
                            settings.files.report,
                            settings.dry_run ? settings.decisions : ""});
}

void
sumUp(const app::RepairSettings& settings, const Result& result)
{
  std::ostream& people = peopleStreamOf(settings);
  if (settings.surveys())
    people << app::summarizeSurvey(settings, result.survey) << std::endl;
  if (settings.dry_run)
    people << app::tellPlan(settings, result.survey) << std::flush;
  if (settings.repairs())
    people << app::summaryName(settings.files.output) << ": "
           << app::summarizeRepair(result.repair) << std::endl;
}

std::string
tellVerdict(const app::RepairSettings& settings, const Result& result)
{
  if (settings.repairs())
    return app::tellSurface(app::surfaceFacts(result.repair));
  return settings.dry_run
             ? app::summarizePlan(app::planRepair(result.survey, settings.method))
             : "inspected";
}

/** \brief Everything up to the files. */
void
work(const app::RepairSettings& settings,
     const app::InspectionView& view,
     app::ProgressBar& bar,
     Result& result)
{
  bar.show("reading", 0);
  readInput(settings, result);
  if (settings.surveys())
    survey(settings, bar, result);
  if (settings.repairs() && bar.show("repairing", 0))
    repair(settings, bar, result);
  if (settings.inspect.empty() || !bar.show("drawing", 0))
    return;
  makeLayers(result);
  if (settings.pictures)
    drawPictures(view, result);
}

/** \brief One input, from its file to all that is written. */
app::Outcome
runOne(const app::RepairSettings& settings,
       const app::InspectionView& view,
       Result& result)
{
  app::ProgressBar bar(settings.quiet);
  work(settings, view, bar, result);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  app::Outcome outcome = judge(settings, result);
  writeOutputs(settings, outcome, result);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.warnings;
  outcome.verdict = {tellVerdict(settings, result), &peopleStreamOf(settings)};
  return outcome;
}

app::Outcome
run(app::RepairSettings& settings, const app::InspectionView& view)
{
  Result result;
  if (!settings.files.isBatch()) {
    checkFiles(settings);
    app::require(app::takeDecisions(settings));
    return runOne(settings, view, result);
  }
  const auto work = [&](const app::FileNames& files, nlohmann::json& report) {
    app::RepairSettings one = settings;
    one.files = files;
    Result its_result;
    const app::Outcome outcome = runOne(one, view, its_result);
    if (outcome.succeeded())
      report = describe(one, outcome, its_result);
    return outcome;
  };
  return app::runBatch(
      {"pcl_repair_holes", settings.files, settings.quiet, !settings.dry_run}, work);
}

} // namespace

int
main(int argc, char** argv)
{
  app::RepairSettings settings;
  app::InspectionView view{1600, 900, {}, {}};
  app::CommandLine line(app::repairUsage(), settings.quiet);
  app::addRepairOptions(line, settings);
  app::addViewOptions(line, view);
  return app::runApp(line, argc, argv, [&] { return run(settings, view); });
}
