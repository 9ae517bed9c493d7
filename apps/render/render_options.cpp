// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the options of pcl_render_mesh.
#include "render/render_options.h"

#include "cli/number_list.h"

#include <array>
#include <string>

namespace app {
namespace {

Status
parseColoring(const std::string& text, Coloring& coloring)
{
  if (text == "none")
    coloring = Coloring::NONE;
  else if (text == "role")
    coloring = Coloring::ROLE;
  else if (text == "component")
    coloring = Coloring::COMPONENT;
  else if (text == "rgb")
    coloring = Coloring::RGB;
  else
    return Status::error("--color-by takes none, role, component or rgb, not '" + text +
                         "'");
  return {};
}

} // namespace

void
addRenderOptions(CommandLine& command_line)
{
  using boost::program_options::value;
  auto add = command_line.addOptions();
  add("size", value<std::string>()->default_value("1200x900"), "WxH in pixels");
  add("view",
      value<std::string>()->default_value("0,0,1"),
      "X,Y,Z: direction from the object to the camera");
  add("view-up",
      value<std::string>()->default_value("0,1,0"),
      "X,Y,Z: direction that points up in the picture");
  add("focus", value<std::string>(), "X,Y,Z: place in the centre of the picture");
  add("zoom", value<double>()->default_value(1.0), "1 shows the whole object");
  add("edges", "draw the edges of the triangles");
  add("no-boundaries", "leave out boundary (red) and overfull (magenta) edges");
  add("color-by",
      value<std::string>()->default_value("none"),
      "none: front faces grey, back faces orange; role: also free points (blue dots) "
      "and boundary points (red dots); component: a colour per connected component; "
      "rgb: the colours of the "
      "points");
  add("new-since",
      value<std::string>(),
      "MESH: an earlier state of the mesh; triangles that it has not are green");
  add("point-size", value<double>()->default_value(2.0), "size of dots in pixels");
}

Status
readSize(const Arguments& arguments, int& width, int& height)
{
  constexpr int largest = 8192;
  const std::string text = takeText(arguments, "size");
  std::array<int, 2> size{};
  if (!parseList(text, 'x', size) || size[0] < 1 || size[1] < 1 || size[0] > largest ||
      size[1] > largest)
    return Status::error("--size takes WxH in pixels from 1x1 to 8192x8192, not '" +
                         text + "'");
  width = size[0];
  height = size[1];
  return {};
}

Status
readDirection(const Arguments& arguments,
              const std::string& option,
              Eigen::Vector3d& direction)
{
  Status status = parsePlace(option, takeText(arguments, option), direction);
  if (status.ok() && direction.norm() < 1e-12)
    return Status::error("--" + option + " must not be zero");
  return status;
}

void
addViewOptions(CommandLine& command_line, const char* default_size)
{
  using boost::program_options::value;
  auto add = command_line.addOptions();
  add("size",
      value<std::string>()->default_value(default_size),
      "of the pictures, WxH in pixels");
  add("view",
      value<std::string>(),
      "X,Y,Z: direction from the model to the camera; without it chosen to show most "
      "of "
      "the boundary");
  add("view-up",
      value<std::string>(),
      "X,Y,Z: direction that points up in the pictures; without it y or z");
}

Status
readView(const Arguments& arguments, InspectionView& view)
{
  Status status = readSize(arguments, view.width, view.height);
  for (const auto& [option, direction] :
       {std::pair{"view", &view.view}, std::pair{"view-up", &view.up}})
    if (status.ok() && arguments.count(option) > 0)
      status =
          readDirection(arguments, option, direction->emplace(Eigen::Vector3d::Zero()));
  return status;
}

Status
readRenderSettings(const Arguments& arguments, RenderSettings& settings)
{
  settings.edges = arguments.count("edges") > 0;
  settings.boundaries = arguments.count("no-boundaries") == 0;
  Status status = readSize(arguments, settings.width, settings.height);
  if (status.ok())
    status = readDirection(arguments, "view", settings.view);
  if (status.ok())
    status = readDirection(arguments, "view-up", settings.up);
  if (status.ok())
    status = parseColoring(takeText(arguments, "color-by"), settings.coloring);
  if (status.ok())
    status = takeReal(arguments, "zoom", 1e-3, 1e6, settings.zoom);
  if (status.ok())
    status = takeReal(arguments, "point-size", 0.1, 100.0, settings.point_size);
  if (status.ok() && arguments.count("focus") > 0)
    status = parsePlace("focus",
                        takeText(arguments, "focus"),
                        settings.focus.emplace(Eigen::Vector3d::Zero()));
  const bool colors_faces =
      settings.coloring == Coloring::COMPONENT || settings.coloring == Coloring::RGB;
  if (status.ok() && colors_faces && arguments.count("new-since") > 0)
    return Status::error("--new-since goes with --color-by none or role only");
  return status;
}

} // namespace app
