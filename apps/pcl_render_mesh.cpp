// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that takes a picture of a mesh or cloud.
#include "common/cli.h"
#include "common/model_io.h"
#include "common/output_file.h"
#include "render/display.h"
#include "render/mesh_parts.h"
#include "render/picture.h"
#include "render/render_options.h"

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
       "  pcl_render_mesh mesh.ply mesh.png --view 1,0,1 --up 0,1,0\n"
       "  pcl_render_mesh mesh.ply detail.png --focus 0.1,0,0.2 --zoom 8 --edges\n"
       "  pcl_render_mesh repaired.ply patches.png --new-since scan.ply\n"});
  command_line.addPositional("MESH_OR_CLOUD");
  command_line.addPositional("OUTPUT");
  app::addRenderOptions(command_line);
  return command_line;
}

app::Status
checkOutput(const std::string& input, const std::string& output)
{
  constexpr std::string_view ending = ".png";
  if (!app::isStandardStream(output) &&
      (output.size() <= ending.size() ||
       output.substr(output.size() - ending.size()) != ending))
    return app::Status::error("'" + output + "' must end in .png");
  const app::Status different = app::checkDifferentFiles({input}, {output});
  return different.ok() ? app::OutputFile::check(output) : different;
}

app::Status
readParts(const std::string& path, app::MeshParts& parts)
{
  app::Model model;
  const app::Status status = app::readModel(path, model);
  if (status.ok())
    parts = app::takeApart(model.mesh);
  return status;
}

/** \brief Load \a path and take it apart; fails when what \a settings want to show is
 * not in it. */
app::Status
loadParts(const std::string& path,
          const app::RenderSettings& settings,
          app::MeshParts& parts)
{
  const app::Status status = readParts(path, parts);
  if (!status.ok())
    return status;
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
  app::MeshParts earlier;
  const app::Status status = readParts(app::takeText(arguments, "new-since"), earlier);
  parts.earlier_faces = earlier.faces;
  return status;
}

app::Status
writePicture(const std::string& png, const std::string& path)
{
  if (png.empty())
    return app::Status::error("the picture could not be drawn");
  app::OutputFile file;
  const app::Status status = file.open(path);
  if (!status.ok())
    return status;
  file.text(png);
  return file.commit();
}

app::Status
renderMesh(const app::Arguments& arguments)
{
  const std::string input = app::takeText(arguments, "MESH_OR_CLOUD");
  const std::string output = app::takeText(arguments, "OUTPUT");
  app::RenderSettings settings;
  app::Status status = app::readRenderSettings(arguments, settings);
  if (status.ok())
    status = checkOutput(input, output);
  if (!status.ok())
    return status;

  app::MeshParts parts;
  status = loadParts(input, settings, parts);
  if (status.ok())
    status = loadEarlierFaces(arguments, parts);
  if (!status.ok())
    return status;
  const app::Display display;
  if (!display.ready())
    return app::Status::error("no X display to draw with: set DISPLAY or install Xvfb");
  return writePicture(app::drawPng(parts, settings), output);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(
      makeCommandLine(), argc, argv, [](const app::Arguments& arguments) {
        const app::Status status = renderMesh(arguments);
        return status.ok() ? app::Outcome{} : app::Outcome::badInput(status);
      });
}
