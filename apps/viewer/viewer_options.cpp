// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_viewer.
#include "viewer/viewer_options.h"

#include "cli/repair_options.h"
#include "io/model_io.h"
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
    names += (names.empty() ? "" : ", ") + name;
  return names;
}

Status
checkChoices(const ViewerSettings& settings)
{
  const auto& names = stageNames();
  if (!settings.stage.empty() &&
      std::find(names.begin(), names.end(), settings.stage) == names.end())
    return Status::error("--stage must be one of " + joinedStageNames() + ", not '" +
                         settings.stage + "'");
  constexpr const char* ending = ".png";
  const std::string& file = settings.screenshot;
  if (!file.empty() && (file.size() < 5 || file.substr(file.size() - 4) != ending))
    return Status::error("'" + file + "' must end in .png");
  return {};
}

} // namespace

CommandLine
makeViewerCommandLine()
{
  CommandLine line(
      {"pcl_repair_viewer",
       "INPUT [options]",
       "Shows how a cloud becomes a surface and a surface is repaired, stage by "
       "stage:\n"
       "cloud, start, filter, base, boundaries, lines, bridges, holes, result. A mesh\n"
       "begins with itself (stage mesh) in place of the first four. In the window n "
       "and "
       "b\nstep through the stages; the other keys are listed there.\n\n"
       "INPUT   cloud " +
           std::string(cloud_endings) + "\n        or mesh " + mesh_endings,
       "  pcl_repair_viewer bunny.pcd\n"
       "  pcl_repair_viewer scan.ply --stage boundaries\n"
       "  pcl_repair_viewer scan.ply --screenshot scan.png\n"
       "  pcl_repair_viewer scan.ply --screenshots pictures --size 1200x800\n"});
  using boost::program_options::value;
  auto add = line.addOptions();
  add("stage",
      value<std::string>(),
      ("stage to be shown: " + joinedStageNames() +
       "; without it the first in the window, the result in a picture")
          .c_str());
  add("screenshot",
      value<std::string>(),
      "open no window, write a picture of the stage to this PNG file");
  add("screenshots",
      value<std::string>(),
      "open no window, write a picture of every stage to this folder (made if "
      "missing)");
  addViewOptions(line, "1280x800");
  add("points-only", "take the points of a mesh alone, as a cloud");
  add("free-points", value<std::string>(), "a cloud of points of the missing regions");
  add("decisions",
      value<std::string>(),
      "JSON file of decisions about boundaries and junctions of a mesh: read if it is "
      "there, written by the key w");
  add("threads",
      value<long long>()->default_value(0),
      "number of threads, 0 = all; the result is the same for any");
  addMethodOptions(line);
  line.addPositional("INPUT");
  return line;
}

Status
takeViewerSettings(const Arguments& arguments, ViewerSettings& settings)
{
  settings.task.input = takeText(arguments, "INPUT");
  settings.task.free_points = takeText(arguments, "free-points");
  settings.task.points_only = arguments.count("points-only") != 0;
  settings.decisions = takeText(arguments, "decisions");
  settings.stage = takeText(arguments, "stage");
  settings.screenshot = takeText(arguments, "screenshot");
  settings.folder = takeText(arguments, "screenshots");
  settings.quiet = arguments.count("quiet") != 0;
  Status status = checkChoices(settings);
  for (const char* option : {"screenshot", "screenshots"})
    if (status.ok() && arguments.count(option) != 0 &&
        takeText(arguments, option).empty())
      status = Status::error(std::string("--") + option + " needs a name");
  if (status.ok())
    status = readView(arguments, settings.view);
  if (status.ok())
    status = takeCount(arguments, "threads", 0, 1024, settings.task.threads);
  if (status.ok())
    status = takeMethod(arguments, settings.task.method);
  return status;
}

} // namespace app
