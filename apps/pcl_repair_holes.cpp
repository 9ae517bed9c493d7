// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that repairs an incomplete model, or shows what it
// lacks.
#include "cli/batch.h"
#include "cli/repair_options.h"
#include "cli/repair_run.h"
#include "cli/run_facts.h"
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

namespace app {
namespace {

/** \brief What was found and done, in all the forms it is handed out. */
struct Result {
  Model model; /**< as it was read; repaired when that is asked for */
  Model free_points;
  pcl::RepairReport repair;
  pcl::repair::ModelSurvey survey;
  pcl::repair::FieldSlice slice;
  std::vector<InspectionLayer> layers;
  std::vector<InspectionPicture> pictures;
  Warnings warnings;
};

/** All that can be known to fail before the work begins. */
void
checkFiles(const RepairSettings& settings)
{
  const FileNames& names = settings.files;
  const std::string decisions = settings.dry_run ? settings.decisions : "";
  std::vector<std::string> files{
      names.output, settings.bridges, names.report, settings.inspect, decisions};
  if (!settings.inspect.empty())
    for (const std::string& name : inspectionNames())
      files.push_back(settings.inspect + "/" + name);
  checkDifferentFiles({names.input(), settings.free_points}, files);
  for (const std::string& file : files)
    require(checkReplaceable(file));
  if (!names.output.empty())
    require(checkMeshOutput(names.target()));
  for (const std::string& file : {settings.bridges, decisions})
    if (!file.empty())
      require(OutputFile::check(file));
  if (!settings.inspect.empty())
    require(OutputFolder::check(settings.inspect));
  if (!names.report.empty() &&
      !OutputFolder::bringsAlong(settings.inspect, names.report))
    require(OutputFile::check(names.report));
}

void
readInput(const RepairSettings& settings, Result& result)
{
  require(readMesh(settings.files.input(), result.model));
  if (!settings.free_points.empty())
    require(readCloud(settings.free_points, result.free_points));
  if (settings.repairs())
    checkCoordinates(settings.files.target(), result.model);
  noteShift(result.model);
  result.warnings = result.model.warnings;
  for (const std::string& warning : result.free_points.warnings)
    result.warnings.push_back("free points: " + warning);
}

RepairTask
taskOf(const RepairSettings& settings, const Result& result)
{
  return {settings.method,
          settings.free_points.empty() ? nullptr : &result.free_points.mesh.cloud,
          settings.threads};
}

[[noreturn]] void
failAbout(const RepairSettings& settings, const std::string& problem)
{
  throw Failure(nameForPeople(settings.files.input()) + ": " + problem);
}

/** \brief Find all that can be told about the model. */
void
survey(const RepairSettings& settings, ProgressBar& bar, Result& result)
{
  RepairTask task = taskOf(settings, result);
  task.method.survey = settings.surveyParameters();
  result.survey = surveyMesh(task,
                             result.model.viewpoint,
                             bar,
                             result.model.mesh,
                             settings.inspect.empty() ? nullptr : &result.slice);
  if (!result.survey.reading.problem.empty())
    failAbout(settings, result.survey.reading.problem);
}

void
repair(const RepairSettings& settings, ProgressBar& bar, Result& result)
{
  try {
    repairMesh(taskOf(settings, result),
               result.model.viewpoint,
               bar,
               result.model.mesh,
               result.repair);
  }
  catch (const Failure& failure) {
    failAbout(settings, failure.what());
  }
}

void
makeLayers(Result& result)
{
  const auto& survey = result.survey;
  result.layers = {showLoops(survey),
                   showIslands(survey),
                   showLines(survey),
                   showLineNormals(survey),
                   showLinePoints(survey),
                   showOrigins(survey),
                   showFreePoints(survey),
                   showSlice(result.slice),
                   showSection(survey, result.slice)};
}

/** \brief Draw the pictures, or say why there are none. */
void
drawPictures(const InspectionView& view, Result& result)
{
  const Display display;
  if (display.ready())
    result.pictures = drawInspection(result.survey, result.slice, result.layers, view);
  else
    result.warnings.push_back("no X display to draw with, so pictures were left out: "
                              "set DISPLAY or install Xvfb");
}

/** \brief How the run ends if the files can be written. */
Outcome
judge(const RepairSettings& settings, const Result& result)
{
  if (settings.dry_run) {
    const RepairPlan plan = planRepair(result.survey, settings.method);
    return plan.isEmpty() ? Outcome() : Outcome{INCOMPLETE, summarizePlan(plan), {}};
  }
  if (settings.repairs() && !result.repair.complete())
    return {INCOMPLETE, tellShortfalls(result.repair, result.model.mesh), {}};
  return {};
}

nlohmann::json
describe(const RepairSettings& settings, const Outcome& outcome, const Result& result)
{
  nlohmann::json report =
      settings.repairs() ? describeRun(settings, result.repair, result.warnings)
                         : describeSurvey(settings, result.survey, result.warnings);
  if (settings.dry_run)
    describePlan(settings, result.survey, report);
  if (settings.repairs() && settings.surveys())
    report["survey"] = describeSurvey(settings, result.survey, {});
  const double seconds = report[settings.repairs() ? "seconds" : "total_seconds"];
  addRunFacts({"pcl_repair_holes",
               settings.files.input(),
               settings.repairs() ? settings.files.output : "",
               outcome.code,
               seconds},
              result.model,
              report);
  return report;
}

void
writeBridges(const std::string& path, const Result& result, OutputFolder& folder)
{
  const pcl::GlobalShift& shift = result.model.shift;
  auto layer = showBridges(result.repair.bridges, shift);
  if (!shift.isNone())
    shift.toGlobal(pcl::PCLPointCloud2(layer.cloud), layer.cloud);
  writeVtkLines(layer.cloud, layer.lines, folder.addElsewhere(path));
}

/** \brief All files appear together or not at all. */
void
writeOutputs(const RepairSettings& settings, const Outcome& outcome, Result& result)
{
  const FileNames& files = settings.files;
  OutputFolder folder;
  if (!settings.inspect.empty()) {
    require(folder.open(settings.inspect));
    writeInspection(result.layers, result.pictures, result.model.shift, folder);
  }
  if (settings.repairs()) {
    FileExtras extras{{}, result.model.viewpoint, result.model.remarks};
    if (settings.labels)
      extras.properties.push_back(originProperty(result.repair));
    writeMesh(files.target(),
              result.model.mesh,
              extras,
              folder.addElsewhere(files.output),
              result.warnings);
  }
  if (!settings.bridges.empty())
    writeBridges(settings.bridges, result, folder);
  if (settings.dry_run && !settings.decisions.empty())
    writeDecisions(files.input(),
                   proposeDecisions(result.survey, settings.method),
                   folder.addElsewhere(settings.decisions));
  // Of many inputs there is one report, at the end.
  if (!files.report.empty() && !files.isBatch())
    writeReport(describe(settings, outcome, result), folder.addElsewhere(files.report));
  require(folder.commit());
}

std::ostream&
peopleStreamOf(const RepairSettings& settings)
{
  return peopleStream({settings.files.output,
                       settings.files.report,
                       settings.dry_run ? settings.decisions : ""});
}

void
sumUp(const RepairSettings& settings, const Result& result)
{
  std::ostream& people = peopleStreamOf(settings);
  if (settings.surveys())
    people << summarizeSurvey(settings, result.survey) << std::endl;
  if (settings.dry_run)
    people << tellPlan(settings, result.survey) << std::flush;
  if (settings.repairs())
    people << summaryName(settings.files.output) << ": "
           << summarizeRepair(result.repair) << std::endl;
}

std::string
tellVerdict(const RepairSettings& settings, const Result& result)
{
  if (settings.repairs())
    return tellSurface(surfaceFacts(result.repair));
  return settings.dry_run ? summarizePlan(planRepair(result.survey, settings.method))
                          : "inspected";
}

/** \brief Everything up to the files. */
void
work(const RepairSettings& settings,
     const InspectionView& view,
     ProgressBar& bar,
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
Outcome
runOne(const RepairSettings& settings, const InspectionView& view, Result& result)
{
  ProgressBar bar(settings.quiet);
  work(settings, view, bar, result);
  if (!bar.show("writing", 0))
    return {INTERRUPTED, stopped_by_signal, {}};
  Outcome outcome = judge(settings, result);
  writeOutputs(settings, outcome, result);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.warnings;
  outcome.verdict = {tellVerdict(settings, result), &peopleStreamOf(settings)};
  return outcome;
}

Outcome
run(RepairSettings& settings, const InspectionView& view)
{
  Result result;
  if (!settings.files.isBatch()) {
    checkFiles(settings);
    takeDecisions(settings);
    return runOne(settings, view, result);
  }
  const auto work = [&](const FileNames& files, nlohmann::json& report) {
    RepairSettings one = settings;
    one.files = files;
    Result its_result;
    const Outcome outcome = runOne(one, view, its_result);
    if (outcome.succeeded())
      report = describe(one, outcome, its_result);
    return outcome;
  };
  return runBatch(
      {"pcl_repair_holes", settings.files, settings.quiet, !settings.dry_run}, work);
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::RepairSettings settings;
  app::InspectionView view{1600, 900, {}, {}};
  app::CommandLine line(app::repairUsage(), settings.quiet);
  app::addRepairOptions(line, settings);
  app::addViewOptions(line, view);
  return app::runApp(line, argc, argv, [&] { return app::run(settings, view); });
}
