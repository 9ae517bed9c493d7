// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that shows what an incomplete model lacks.
#include <pcl/surface_ccaa/threads.h>

#include "common/cli.h"
#include "common/cloud_normals.h"
#include "common/inspection_files.h"
#include "common/model_io.h"
#include "common/progress.h"
#include "common/repair_options.h"
#include "common/repair_report.h"
#include "common/report.h"
#include "render/display.h"
#include "render/inspection_pictures.h"
#include "render/render_options.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace {

/** Points of the slice through the field along its longer side. */
constexpr std::size_t SLICE_COLUMNS = 400;

/** \brief What was found, in all the forms it is handed out. */
struct Result {
  pcl::repair::ModelSurvey survey;
  pcl::repair::FieldSlice slice;
  std::vector<app::InspectionLayer> layers;
  std::vector<app::InspectionPicture> pictures;
  app::Warnings warnings;
};

app::CommandLine
makeCommandLine()
{
  app::CommandLine line(
      {"pcl_repair_holes",
       "INPUT_MESH --inspect DIR [options]",
       "Finds what a mesh lacks: tells holes from the rims of islands and from the\n"
       "outer border, which side of each island is outside, and how force lines join\n"
       "what belongs together. Points without a triangle are free points, samples of\n"
       "the missing regions. Any mesh will do: faults are taken out on reading.\n\n"
       "INPUT_MESH   " +
           std::string(app::mesh_endings),
       "  pcl_repair_holes scan.ply --inspect found --report found.json\n"
       "  pcl_repair_holes scan.ply --inspect found --free-points sparse.pcd --mode "
       "full\n"
       "  pcl_viewer found/origins.pcd found/islands.vtk found/loops.vtk\n"});
  app::addRepairOptions(line);
  using boost::program_options::value;
  auto add = line.addOptions();
  add("size", value<std::string>()->default_value("1600x900"), "of the pictures, WxH");
  add("view",
      value<std::string>(),
      "X,Y,Z: direction from the model to the camera; without it one or two are chosen "
      "that show most of the boundary");
  add("up",
      value<std::string>(),
      "X,Y,Z: direction that points up in the pictures; without it y or z");
  line.addPositional("INPUT_MESH");
  return line;
}

app::Status
readView(const app::Arguments& arguments, app::InspectionView& view)
{
  app::Status status = app::readSize(arguments, view.width, view.height);
  for (const auto& [option, direction] :
       {std::pair{"view", &view.view}, std::pair{"up", &view.up}})
    if (status.ok() && arguments.count(option) > 0)
      status = app::readDirection(
          arguments, option, direction->emplace(Eigen::Vector3d::Zero()));
  return status;
}

/** The report may lie in the folder that is yet to be made. */
bool
comesWithFolder(const app::RepairSettings& settings)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::exists(settings.inspect, ignored))
    return false;
  const auto folder_of = [&](const std::string& file) {
    return fs::weakly_canonical(file, ignored).parent_path();
  };
  return folder_of(settings.report) == folder_of(settings.inspect + "/any");
}

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::RepairSettings& settings)
{
  std::vector<std::string> files{
      settings.input, settings.free_points, settings.report, settings.inspect};
  for (const std::string& name : app::inspectionNames())
    files.push_back(settings.inspect + "/" + name);
  app::Status status = app::checkDifferentFiles(files);
  if (status.ok())
    status = app::OutputFolder::check(settings.inspect);
  if (status.ok() && !settings.report.empty() && !comesWithFolder(settings))
    status = app::OutputFile::check(settings.report);
  return status;
}

/** \brief Read the model and find all that can be told about it. */
app::Status
survey(const app::RepairSettings& settings, app::ProgressBar& bar, Result& result)
{
  app::Model model;
  app::Model free_points;
  bar.show("reading", 0);
  app::Status status = app::readMesh(settings.input, model);
  if (status.ok() && !settings.free_points.empty())
    status = app::readCloud(settings.free_points, free_points);
  if (!status.ok())
    return status;
  result.warnings = model.warnings;
  appendViewpoint(model.viewpoint, model.mesh.cloud);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::LoopContext context;
  context.threads = pcl::ccaa::resolveThreads(settings.threads);
  context.control = &control;
  result.survey =
      surveyModel(pcl::make_shared<const pcl::PolygonMesh>(std::move(model.mesh)),
                  settings.free_points.empty() ? nullptr : &free_points.mesh.cloud,
                  settings.survey,
                  context);
  if (!result.survey.reading.problem.empty())
    return app::Status::error("'" + settings.input +
                              "': " + result.survey.reading.problem);
  if (!result.survey.cancelled)
    result.slice =
        sliceField(result.survey, settings.survey.field, SLICE_COLUMNS, context);
  return {};
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

app::Status
writeOutputs(const app::RepairSettings& settings, const Result& result)
{
  app::OutputFolder folder;
  const app::Status status = folder.open(settings.inspect);
  if (!status.ok())
    return status;
  writeInspection(result.layers, result.pictures, folder);
  if (!settings.report.empty())
    app::writeReport(app::describeSurvey(settings, result.survey, result.warnings),
                     folder.addElsewhere(settings.report));
  return folder.commit();
}

app::Outcome
repair(const app::Arguments& arguments)
{
  app::RepairSettings settings;
  app::InspectionView view;
  Result result;
  app::Status status = app::takeRepairSettings(arguments, settings);
  if (status.ok())
    status = readView(arguments, view);
  if (status.ok())
    status = checkFiles(settings);
  if (!status.ok())
    return app::Outcome::badInput(status);
  app::ProgressBar bar(settings.quiet);
  status = survey(settings, bar, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (bar.show("drawing", 0)) {
    makeLayers(result);
    if (settings.pictures)
      drawPictures(view, result);
  }
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, "stopped by a signal; nothing was written", {}};
  status = writeOutputs(settings, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  if (!settings.quiet)
    std::cout << app::summarizeSurvey(settings, result.survey) << std::endl;
  return {app::DONE, "", result.warnings};
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, repair);
}
