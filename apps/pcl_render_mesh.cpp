// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that takes a picture of a mesh or cloud.
#include "cli/cli.h"
#include "cli/file_names.h"
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

namespace app {
namespace {

Usage
usage()
{
  return {
      "pcl_render_mesh",
      "MESH_OR_CLOUD OUTPUT.png [options]",
      "Takes a picture of a mesh or cloud, without a window and without perspective.\n"
      "Front faces are grey, back faces orange, boundary edges red, and edges of\n"
      "three or more triangles magenta; --new-since shows what a program has added.\n"
      "Reads\n" +
          std::string(cloud_endings) +
          ".\n'-' reads standard input and writes the PNG to standard output.",
      "  pcl_render_mesh mesh.ply mesh.png --view 1,0,1 --view-up 0,1,0\n"
      "  pcl_render_mesh mesh.ply detail.png --focus 0.1,0,0.2 --zoom 8 --edges\n"
      "  pcl_render_mesh repaired.ply patches.png --new-since scan.ply\n"};
}

struct Settings {
  std::string input;
  std::string output;
  std::string report; /**< empty: none */
  bool quiet = false;
  RenderSettings picture;
};

void
checkFiles(const Settings& settings)
{
  const std::string& output = settings.output;
  if (!isStandardStream(output))
    checkPictureName(output);
  checkDifferentFiles({settings.input}, {output, settings.report});
  require(OutputFile::check(output));
  if (!settings.report.empty())
    require(OutputFile::check(settings.report));
}

MeshParts
readParts(const std::string& path, Model& model)
{
  require(readModel(path, model));
  return takeApart(model.mesh, model.shift);
}

/** \brief Load the input and take it apart; fails when what is to be shown is not in
 * it. */
MeshParts
loadParts(const Settings& settings, Model& model)
{
  MeshParts parts = readParts(settings.input, model);
  const std::string name = nameForPeople(settings.input);
  noteShift(model);
  if (parts.positions.empty())
    throw Failure(name + " has no finite point to show");
  if (settings.picture.coloring == Coloring::RGB && !parts.colors)
    throw Failure("the points of " + name + " have no colours");
  if (!settings.picture.new_since.empty()) {
    Model earlier;
    parts.earlier_faces = readParts(settings.picture.new_since, earlier).faces;
  }
  return parts;
}

void
writeFiles(const Settings& settings,
           const Model& model,
           const std::string& png,
           double seconds)
{
  if (png.empty())
    throw Failure("the picture could not be drawn");
  OutputFolder outputs;
  outputs.addElsewhere(settings.output).text(png);
  if (!settings.report.empty()) {
    nlohmann::json report = {{"points", pointCount(model.mesh.cloud)},
                             {"polygons", model.mesh.polygons.size()},
                             {"width", settings.picture.width},
                             {"height", settings.picture.height},
                             {"warnings", model.warnings}};
    addRunFacts({"pcl_render_mesh", settings.input, settings.output, DONE, seconds},
                model,
                report);
    writeReport(report, outputs.addElsewhere(settings.report));
  }
  require(outputs.commit());
}

Outcome
renderMesh(Settings& settings)
{
  Model model;
  checkFiles(settings);
  const MeshParts parts = loadParts(settings, model);
  if (settings.picture.focus)
    *settings.picture.focus -= model.shift.offset();
  const Display display;
  if (!display.ready())
    throw Failure("no X display to draw with: set DISPLAY or install Xvfb");
  Stopwatch watch;
  const std::string png = drawPng(parts, settings.picture);
  writeFiles(settings, model, png, watch.lap());
  std::ostream& people = peopleStream({settings.output, settings.report});
  if (!settings.quiet)
    people << summaryName(settings.output) << ": " << settings.picture.width << " x "
           << settings.picture.height << " pixels, "
           << plural(pointCount(model.mesh.cloud), "point") << ", "
           << plural(model.mesh.polygons.size(), "polygon") << "\n";
  return {DONE, "", model.warnings, {"1 picture", &people}};
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::Settings settings;
  app::CommandLine line(app::usage(), settings.quiet);
  line.positional("MESH_OR_CLOUD", settings.input);
  line.positional("OUTPUT", settings.output);
  app::addRenderOptions(line, settings.picture);
  line.options().text("report", settings.report)(
      "write figures about the picture to this JSON file, or to standard output (-)",
      "where a program goes on with the figures");
  return app::runApp(line, argc, argv, [&] { return app::renderMesh(settings); });
}
