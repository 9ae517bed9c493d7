// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_viewer.
#include "viewer/viewer_options.h"

#include "cli/method_options.h"
#include "io/model_io.h"
#include "io/wording.h"
#include "render/render_options.h"
#include "viewer/stages.h"

#include <algorithm>

namespace app {
namespace {

std::string
joinedStageNames()
{
  std::string names;
  for (const std::string& name : stageNames())
    addToList(names, name);
  return names;
}

void
checkChoices(const ViewerSettings& settings)
{
  const auto& names = stageNames();
  if (!settings.stage.empty() &&
      std::find(names.begin(), names.end(), settings.stage) == names.end())
    throw Failure("--stage must be one of " + joinedStageNames() + ", not '" +
                  settings.stage + "'");
  if (!settings.screenshot.empty())
    checkPictureName(settings.screenshot);
}

} // namespace

Usage
viewerUsage()
{
  return {
      "pcl_repair_viewer",
      "[INPUT] [options]",
      "Shows how a cloud becomes a surface and a surface is repaired, stage by stage:\n"
      "cloud, start, filter, base, boundaries, lines, bridges, holes, result. A mesh\n"
      "begins with itself (stage mesh) in place of the first four. In the window n and "
      "b\n"
      "step through the stages; the other keys are listed there. Keys that would lose\n"
      "decisions which are not saved, f and q, say so first. Without INPUT a dialog "
      "asks\n"
      "for it.\n\n"
      "INPUT   cloud " +
          std::string(cloud_endings) + "\n        or mesh " + mesh_endings,
      "  pcl_repair_viewer bunny.pcd\n"
      "  pcl_repair_viewer scan.ply --stage boundaries\n"
      "  pcl_repair_viewer scan.ply --screenshot scan.png\n"
      "  pcl_repair_viewer scan.ply --screenshots pictures --size 1200x800\n"};
}

void
addViewerOptions(CommandLine& command_line, ViewerSettings& settings)
{
  OptionGroup& options = command_line.options();
  options.text("stage", settings.stage)(
      "stage to be shown: " + joinedStageNames() +
          "; without it the first in the window, the result in a picture",
      "to begin where the question is");
  options.name("screenshot", settings.screenshot)(
      "open no window, write a picture of the stage to this PNG file",
      "for pictures in scripts");
  options.name("screenshots",
               settings.folder)("open no window, write a picture of every stage to "
                                "this folder (made if missing)",
                                "to document a repair");
  addViewOptions(command_line, settings.view);
  options.flag("points-only", settings.task.points_only)(
      "take the points of a mesh alone, as a cloud",
      "to see how a cloud without its triangles would do");
  options.text("free-points", settings.task.free_points)(
      "a cloud of points of the missing regions",
      "where a second scan or a probe has touched what is missing");
  options.text("decisions", settings.decisions)(
      "JSON file of decisions about boundaries and junctions of a mesh: read if it is "
      "there, written by the key w; without it that writes INPUT_decisions.json",
      "to go on with earlier decisions, or to keep several");
  options.name("output,o", settings.output)(
      "file for the mesh that the key y repairs as decided; without it "
      "INPUT_repaired.ply beside the input",
      "where the result has a place of its own");
  addThreads(command_line, settings.task.threads);
  command_line.then([&settings] { return checkChoices(settings); });
  addMethodOptions(command_line, settings.task.method);
  command_line.positional("INPUT", settings.inputs, false);
  command_line.then([&settings] {
    settings.task.input = settings.inputs.empty() ? "" : settings.inputs.front();
  });
}

} // namespace app
