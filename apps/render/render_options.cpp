// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of pictures.
#include "render/render_options.h"

#include "cli/number_list.h"

#include <array>
#include <string>

namespace app {
namespace {

constexpr Word<Coloring> COLORINGS[] = {{"none", Coloring::NONE},
                                        {"role", Coloring::ROLE},
                                        {"component", Coloring::COMPONENT},
                                        {"rgb", Coloring::RGB}};

void
addSize(OptionGroup& options,
        int& width,
        int& height,
        const std::string& help,
        const std::string& use)
{
  const auto take = [&](const std::string& text) {
    constexpr int largest = 8192;
    std::array<int, 2> size{};
    if (!parseList(text, 'x', size) || size[0] < 1 || size[1] < 1 ||
        size[0] > largest || size[1] > largest)
      throw Failure("--size takes WxH in pixels from 1x1 to 8192x8192, not '" + text +
                    "'");
    width = size[0];
    height = size[1];
  };
  options.parsed("size", take, std::to_string(width) + "x" + std::to_string(height))(
      help, use);
}

/** A direction has a length. */
void
takeDirection(const std::string& option,
              const std::string& text,
              Eigen::Vector3d& direction)
{
  parsePlace(option, text, direction);
  if (direction.norm() < 1e-12)
    throw Failure("--" + option + " must not be zero");
}

} // namespace

void
addRenderOptions(CommandLine& command_line, RenderSettings& settings)
{
  OptionGroup& options = command_line.options();
  const auto add_direction = [&](const std::string& name,
                                 Eigen::Vector3d& direction,
                                 const std::string& help,
                                 const std::string& use,
                                 const std::string& default_text) {
    const auto take = [&direction, name](const std::string& text) {
      return takeDirection(name, text, direction);
    };
    options.parsed(name, take, default_text)(help, use);
  };
  addSize(options,
          settings.width,
          settings.height,
          "WxH in pixels",
          "to fit a page or a screen");
  add_direction("view",
                settings.view,
                "X,Y,Z: direction from the object to the camera",
                "to see another side",
                "0,0,1");
  add_direction("view-up",
                settings.up,
                "X,Y,Z: direction that points up in the picture",
                "where z, not y, is up: 0,0,1",
                "0,1,0");
  options.parsed("focus", [&settings](const std::string& text) {
    return parsePlace("focus", text, settings.focus.emplace(Eigen::Vector3d::Zero()));
  })("X,Y,Z: place in the centre of the picture", "with --zoom for details");
  options.real("zoom", settings.zoom, 1e-3, 1e6)("1 shows the whole object",
                                                 "above 1 for details");
  options.flag("edges", settings.edges)("draw the edges of the triangles",
                                        "to see how dense the mesh is");
  options.flag("no-boundaries", settings.boundaries, false)(
      "leave out boundary (red) and overfull (magenta) edges",
      "where only the shape matters");
  options.choice("color-by", settings.coloring, COLORINGS)(
      "none: front faces grey, back faces orange; role: also free points (blue dots) "
      "and boundary points (red dots); component: a colour per connected component; "
      "rgb: the colours of the points",
      "as role to find free points, as component to find loose parts");
  options.text("new-since", settings.new_since)(
      "MESH: an earlier state of the mesh; triangles that it has not are green",
      "to see what a repair has added");
  options.real("point-size", settings.point_size, 0.1, 100.0)(
      "size of dots in pixels", "lower for dense clouds, higher for sparse ones");
  command_line.then([&settings] {
    const bool colors_faces =
        settings.coloring == Coloring::COMPONENT || settings.coloring == Coloring::RGB;
    if (colors_faces && !settings.new_since.empty())
      throw Failure("--new-since goes with --color-by none or role only");
  });
}

void
addViewOptions(CommandLine& command_line, InspectionView& view)
{
  OptionGroup& options = command_line.options();
  const auto add_direction = [&](const std::string& name,
                                 std::optional<Eigen::Vector3d>& direction,
                                 const std::string& help,
                                 const std::string& use) {
    options.parsed(name, [&direction, name](const std::string& text) {
      return takeDirection(name, text, direction.emplace(Eigen::Vector3d::Zero()));
    })(help, use);
  };
  addSize(options,
          view.width,
          view.height,
          "of the pictures, WxH in pixels",
          "to fit a page or a screen");
  add_direction("view",
                view.view,
                "X,Y,Z: direction from the model to the camera; without it chosen to "
                "show most of the boundary",
                "to see another side");
  add_direction("view-up",
                view.up,
                "X,Y,Z: direction that points up in the pictures; without it y or z",
                "where another axis is up");
}

void
checkPictureName(const std::string& name)
{
  if (name.size() <= 4 || name.substr(name.size() - 4) != ".png")
    throw Failure("'" + name + "' must end in .png");
}

} // namespace app
