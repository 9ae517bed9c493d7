// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that repairs an incomplete model, or shows what it
// lacks.
#include "cli/batch.h"
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/repair_options.h"
#include "cli/repair_run.h"
#include "cli/run_facts.h"
#include "cli/side_options.h"
#include "inspect/bridge_layer.h"
#include "inspect/inspection_files.h"
#include "io/decisions_file.h"
#include "io/mesh_writers.h"
#include "io/model_io.h"
#include "io/overwriting.h"
#include "io/position_check.h"
#include "render/display.h"
#include "render/inspection_pictures.h"
#include "render/render_options.h"
#include "repair/decision_proposal.h"
#include "report/dry_run.h"
#include "report/hole_report.h"
#include "report/repair_report.h"
#include "report/verdict.h"
#include "run/threads.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace {

/** Points of the slice through the field along its longer side. */
constexpr std::size_t SLICE_COLUMNS = 400;

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

app::CommandLine
makeCommandLine()
{
  app::CommandLine line(app::repairUsage());
  app::addRepairOptions(line);
  app::addViewOptions(line, "1600x900");
  return line;
}

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::RepairSettings& settings)
{
  std::vector<std::string> files{
      settings.output, settings.bridges, settings.report, settings.inspect};
  if (settings.dry_run)
    files.push_back(settings.decisions);
  if (!settings.inspect.empty())
    for (const std::string& name : app::inspectionNames())
      files.push_back(settings.inspect + "/" + name);
  app::Status status =
      app::checkDifferentFiles({settings.input, settings.free_points}, files);
  for (const std::string& file : files)
    if (status.ok())
      status = app::checkReplaceable(file);
  if (status.ok() && !settings.output.empty())
    status = app::checkMeshOutput(settings.target());
  if (status.ok() && !settings.bridges.empty())
    status = app::OutputFile::check(settings.bridges);
  if (status.ok() && settings.dry_run && !settings.decisions.empty())
    status = app::OutputFile::check(settings.decisions);
  if (status.ok() && !settings.inspect.empty())
    status = app::OutputFolder::check(settings.inspect);
  if (status.ok() && !settings.report.empty() &&
      !app::OutputFolder::bringsAlong(settings.inspect, settings.report))
    status = app::OutputFile::check(settings.report);
  return status;
}

app::Status
readInput(const app::RepairSettings& settings, Result& result)
{
  app::Status status = app::readMesh(settings.input, result.model);
  if (status.ok() && !settings.free_points.empty())
    status = app::readCloud(settings.free_points, result.free_points);
  if (status.ok() && settings.repairs())
    status = app::checkCoordinates(settings.target(), result.model);
  app::noteShift(result.model);
  result.warnings = result.model.warnings;
  for (const std::string& warning : result.free_points.warnings)
    result.warnings.push_back("free points: " + warning);
  return status;
}

const pcl::PCLPointCloud2*
freePoints(const app::RepairSettings& settings, const Result& result)
{
  return settings.free_points.empty() ? nullptr : &result.free_points.mesh.cloud;
}

/** \brief Find all that can be told about the model. */
app::Status
survey(const app::RepairSettings& settings, app::ProgressBar& bar, Result& result)
{
  pcl::repair::SurveyParameters parameters = settings.surveyParameters();
  pcl::ccaa::SideHints& sides = parameters.orientation.sides;
  sides = app::sidesOf(sides, result.model.viewpoint);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::LoopContext context;
  context.threads = pcl::ccaa::resolveThreads(settings.threads);
  context.control = &control;
  result.survey =
      surveyModel(pcl::make_shared<const pcl::PolygonMesh>(result.model.mesh),
                  freePoints(settings, result),
                  parameters,
                  context);
  const std::string& problem = result.survey.reading.problem;
  if (!problem.empty())
    return app::Status::error(app::nameForPeople(settings.input) + ": " + problem);
  if (!result.survey.cancelled && !settings.inspect.empty())
    result.slice =
        sliceField(result.survey, settings.method.survey.field, SLICE_COLUMNS, context);
  return {};
}

app::Status
repair(const app::RepairSettings& settings, app::ProgressBar& bar, Result& result)
{
  const app::Status status =
      app::repairMesh({settings.method, freePoints(settings, result), settings.threads},
                      result.model.viewpoint,
                      bar,
                      result.model.mesh,
                      result.repair);
  return status.ok() ? status
                     : app::Status::error(app::nameForPeople(settings.input) + ": " +
                                          status.message());
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
                    settings.input,
                    settings.repairs() ? settings.output : "",
                    outcome.code,
                    seconds,
                    result.model.remarks,
                    result.model.shift},
                   report);
  return report;
}

/** \brief All files appear together or not at all. */
app::Status
writeOutputs(const app::RepairSettings& settings,
             const app::Outcome& outcome,
             Result& result)
{
  app::OutputFolder folder;
  app::Status status;
  if (!settings.inspect.empty())
    status = folder.open(settings.inspect);
  if (!status.ok())
    return status;
  if (!settings.inspect.empty())
    writeInspection(result.layers, result.pictures, result.model.shift, folder);
  if (settings.repairs()) {
    app::FileExtras extras{{}, result.model.viewpoint, result.model.remarks};
    if (settings.labels)
      extras.properties.push_back(app::originProperty(result.repair));
    app::writeMesh(settings.target(),
                   result.model.mesh,
                   extras,
                   folder.addElsewhere(settings.output),
                   result.warnings);
  }
  if (!settings.bridges.empty()) {
    auto layer = app::showBridges(result.repair.bridges, result.model.shift);
    if (!result.model.shift.isNone())
      result.model.shift.toGlobal(pcl::PCLPointCloud2(layer.cloud), layer.cloud);
    app::writeVtkLines(layer.cloud, layer.lines, folder.addElsewhere(settings.bridges));
  }
  if (settings.dry_run && !settings.decisions.empty())
    app::writeDecisions(settings.input,
                        proposeDecisions(result.survey, settings.method),
                        folder.addElsewhere(settings.decisions));
  // Of many inputs there is one report, at the end.
  if (!settings.report.empty() && settings.output_folder.empty())
    app::writeReport(describe(settings, outcome, result),
                     folder.addElsewhere(settings.report));
  return folder.commit();
}

std::ostream&
peopleStreamOf(const app::RepairSettings& settings)
{
  return app::peopleStream(
      {settings.output, settings.report, settings.dry_run ? settings.decisions : ""});
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
    people << app::summaryName(settings.output) << ": "
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
app::Status
work(const app::RepairSettings& settings,
     const app::InspectionView& view,
     app::ProgressBar& bar,
     Result& result)
{
  bar.show("reading", 0);
  app::Status status = readInput(settings, result);
  if (status.ok() && settings.surveys())
    status = survey(settings, bar, result);
  if (status.ok() && settings.repairs() && bar.show("repairing", 0))
    status = repair(settings, bar, result);
  if (status.ok() && !settings.inspect.empty() && bar.show("drawing", 0)) {
    makeLayers(result);
    if (settings.pictures)
      drawPictures(view, result);
  }
  return status;
}

/** \brief One input, from its file to all that is written. */
app::Outcome
runOne(const app::RepairSettings& settings,
       const app::InspectionView& view,
       Result& result)
{
  app::ProgressBar bar(settings.quiet);
  app::Status status = work(settings, view, bar, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  app::Outcome outcome = judge(settings, result);
  status = writeOutputs(settings, outcome, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  if (!settings.quiet)
    sumUp(settings, result);
  outcome.notes = result.warnings;
  outcome.verdict = {tellVerdict(settings, result), &peopleStreamOf(settings)};
  return outcome;
}

/** \brief All inputs, with one report about them. */
app::Outcome
runMany(const app::RepairSettings& settings, const app::InspectionView& view)
{
  const app::BatchSettings batch{"pcl_repair_holes",
                                 settings.inputs,
                                 settings.output_folder,
                                 settings.report,
                                 settings.format,
                                 settings.quiet,
                                 !settings.dry_run};
  return app::runBatch(batch, [&](const app::BatchItem& item, nlohmann::json& report) {
    app::RepairSettings one = settings;
    one.input = item.input;
    one.output = item.output;
    Result result;
    app::Outcome outcome = runOne(one, view, result);
    if (outcome.code == app::DONE || outcome.code == app::INCOMPLETE)
      report = describe(one, outcome, result);
    return outcome;
  });
}

app::Outcome
run(const app::Arguments& arguments)
{
  app::RepairSettings settings;
  app::InspectionView view;
  app::Status status = app::takeRepairSettings(arguments, settings);
  if (status.ok())
    status = app::readView(arguments, view);
  if (status.ok() && !settings.inputs.empty())
    return runMany(settings, view);
  if (status.ok())
    status = checkFiles(settings);
  if (status.ok())
    status = app::takeDecisions(settings);
  if (!status.ok())
    return app::Outcome::badInput(status);
  Result result;
  return runOne(settings, view, result);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, run);
}
