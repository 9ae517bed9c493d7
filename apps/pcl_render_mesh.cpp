// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that takes a picture of a mesh or cloud.
#include "cli/cli.h"
#include "cli/output_format.h"
#include "cli/run_facts.h"
#include "io/model_io.h"
#include "io/output_folder.h"
#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "render/display.h"
#include "render/mesh_parts.h"
#include "render/picture.h"
#include "render/render_options.h"
#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <string_view>

namespace {

app::CommandLine
makeCommandLine()
{
  app::CommandLine command_line(
      {"pcl_render_mesh",
       "MESH_OR_CLOUD OUTPUT.png [options]",
       "Takes a picture of a mesh or cloud, without a window and without perspective.\n"
       "Front faces are grey, back faces orange, boundary edges red, and edges of\n"
       "three or more triangles magenta; --new-since shows what a program has added.\n"
       "Reads\n" +
           std::string(app::cloud_endings) +
           ".\n'-' reads standard input and writes the PNG to standard output.",
       "  pcl_render_mesh mesh.ply mesh.png --view 1,0,1 --view-up 0,1,0\n"
       "  pcl_render_mesh mesh.ply detail.png --focus 0.1,0,0.2 --zoom 8 --edges\n"
       "  pcl_render_mesh repaired.ply patches.png --new-since scan.ply\n"});
  command_line.addPositional("MESH_OR_CLOUD");
  command_line.addPositional("OUTPUT");
  app::addRenderOptions(command_line);
  command_line.addOptions()(
      "report",
      boost::program_options::value<std::string>(),
      "write figures about the picture to this JSON file, or to standard output (-)");
  return command_line;
}

struct Files {
  std::string input;
  std::string output;
  std::string report; /**< empty: none */
};

app::Status
checkFiles(const Files& files)
{
  constexpr std::string_view ending = ".png";
  const std::string& output = files.output;
  if (!app::isStandardStream(output) &&
      (output.size() <= ending.size() ||
       output.substr(output.size() - ending.size()) != ending))
    return app::Status::error("'" + output + "' must end in .png");
  app::Status status = app::checkDifferentFiles({files.input}, {output, files.report});
  if (status.ok())
    status = app::OutputFile::check(output);
  if (status.ok() && !files.report.empty())
    status = app::OutputFile::check(files.report);
  return status;
}

app::Status
readParts(const std::string& path, app::Model& model, app::MeshParts& parts)
{
  const app::Status status = app::readModel(path, model);
  if (status.ok())
    parts = app::takeApart(model.mesh, model.shift);
  return status;
}

/** \brief Load \a path and take it apart; fails when what \a settings want to show is
 * not in it. */
app::Status
loadParts(const std::string& path,
          const app::RenderSettings& settings,
          app::Model& model,
          app::MeshParts& parts)
{
  const app::Status status = readParts(path, model, parts);
  if (!status.ok())
    return status;
  app::noteShift(model);
  if (parts.positions.empty())
    return app::Status::error(app::nameForPeople(path) +
                              " has no finite point to show");
  if (settings.coloring == app::Coloring::RGB && !parts.colors)
    return app::Status::error("the points of " + app::nameForPeople(path) +
                              " have no colours");
  return {};
}

/** \brief Load the faces of an earlier state where there is the option for it. */
app::Status
loadEarlierFaces(const app::Arguments& arguments, app::MeshParts& parts)
{
  if (arguments.count("new-since") == 0)
    return {};
  app::Model model;
  app::MeshParts earlier;
  const app::Status status =
      readParts(app::takeText(arguments, "new-since"), model, earlier);
  parts.earlier_faces = earlier.faces;
  return status;
}

app::Status
writeFiles(const Files& files,
           const app::RenderSettings& settings,
           const app::Model& model,
           const std::string& png,
           double seconds)
{
  if (png.empty())
    return app::Status::error("the picture could not be drawn");
  app::OutputFolder outputs;
  outputs.addElsewhere(files.output).text(png);
  if (!files.report.empty()) {
    nlohmann::json report = {{"points", app::pointCount(model.mesh.cloud)},
                             {"polygons", model.mesh.polygons.size()},
                             {"width", settings.width},
                             {"height", settings.height},
                             {"warnings", model.warnings}};
    app::addRunFacts({"pcl_render_mesh",
                      files.input,
                      files.output,
                      app::DONE,
                      seconds,
                      model.remarks,
                      model.shift},
                     report);
    app::writeReport(report, outputs.addElsewhere(files.report));
  }
  return outputs.commit();
}

void
sumUp(const Files& files, const app::RenderSettings& settings, const app::Model& model)
{
  app::peopleStream({files.output, files.report})
      << app::summaryName(files.output) << ": " << settings.width << " x "
      << settings.height << " pixels, "
      << app::plural(app::pointCount(model.mesh.cloud), "point") << ", "
      << app::plural(model.mesh.polygons.size(), "polygon") << "\n";
}

app::Outcome
renderMesh(const app::Arguments& arguments)
{
  const Files files{app::takeText(arguments, "MESH_OR_CLOUD"),
                    app::takeText(arguments, "OUTPUT"),
                    app::takeText(arguments, "report")};
  app::RenderSettings settings;
  app::Model model;
  app::MeshParts parts;
  app::Status status = app::readRenderSettings(arguments, settings);
  if (status.ok())
    status = checkFiles(files);
  if (status.ok())
    status = loadParts(files.input, settings, model, parts);
  if (status.ok())
    status = loadEarlierFaces(arguments, parts);
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (settings.focus)
    *settings.focus -= model.shift.offset();
  const app::Display display;
  if (!display.ready())
    return app::Outcome::badInput(
        app::Status::error("no X display to draw with: set DISPLAY or install Xvfb"));
  app::Stopwatch watch;
  const std::string png = app::drawPng(parts, settings);
  status = writeFiles(files, settings, model, png, watch.lap());
  if (!status.ok())
    return app::Outcome::badInput(status);
  if (arguments.count("quiet") == 0)
    sumUp(files, settings, model);
  return {app::DONE,
          "",
          model.warnings,
          {"1 picture", &app::peopleStream({files.output, files.report})}};
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, renderMesh);
}
