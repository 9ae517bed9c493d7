// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_holes.
#include "repair_options.h"

namespace app {
namespace {

void
checkManyInputs(const RepairSettings& settings)
{
  if (!settings.inspect.empty() || !settings.bridges.empty() ||
      !settings.decisions.empty())
    throw Failure("--inspect, --bridges and --decisions are about one model; they do "
                  "not go with --output-folder");
  if (settings.labels && !holdsFaceProperties(settings.files.target()))
    throw Failure("--labels needs --format ply");
}

/** Options that do not go together, or ask for nothing. */
void
checkOutputs(const CommandLine& line, const RepairSettings& settings)
{
  const FileNames& files = settings.files;
  if (line.given("inspect") && settings.inspect.empty())
    throw Failure("--inspect needs the name of a folder");
  if (!settings.repairs() && !settings.surveys() && !files.isBatch())
    throw Failure(
        "nothing is asked for: name an OUTPUT_MESH for the repaired surface, or use "
        "--inspect DIR or --dry-run to see what is missing (try --help)");
  if (settings.dry_run && !settings.inspect.empty())
    throw Failure(
        "--dry-run writes nothing but the report; it does not go with --inspect");
  if (files.isBatch())
    return checkManyInputs(settings);
  if (files.output.empty() && (!settings.bridges.empty() || settings.labels))
    throw Failure(
        "--bridges and --labels tell about a repair; they need an OUTPUT_MESH");
  if (files.output.empty() && !settings.dry_run && !settings.decisions.empty())
    throw Failure("--decisions is written with --dry-run and read with an OUTPUT_MESH");
  if (settings.labels && !holdsFaceProperties(files.target()))
    throw Failure("--labels needs an output that ends in .ply, not '" + files.output +
                  "'");
}

void
addRunOptions(OptionGroup& options, RepairSettings& settings)
{
  options.text("free-points", settings.free_points)(
      "a cloud of points of the missing regions",
      "where a second scan or a probe has touched what is missing");
  options.flag("dry-run", settings.dry_run)(
      "say what would be repaired, and write nothing but the report; exit code 0: "
      "nothing to do, 2: something",
      "before anything is invented, and in scripts");
  options.text("report", settings.files.report)(
      "write figures about the model to this JSON file, or to standard output (-)",
      "where a program goes on with the figures");
  options.flag("labels", settings.labels)(
      "write how each triangle came about as the face property 'origin': 0 input, 1 "
      "fan, 2 minimum weight, 3 completion; PLY only",
      "to tell what was measured from what was invented");
  options.text("bridges", settings.bridges)(
      "write the bridges that were built, with normals and quality, to this .vtk file",
      "to see how islands were joined");
  options.text("inspect", settings.inspect)(
      "write what was found to this folder (made if missing): .vtk and .pcd files for "
      "pcl_viewer, PNG pictures, and legend.txt, which explains them",
      "to see what is missing, and why something stays open");
  options.flag("no-pictures", settings.pictures, false)(
      "leave out the pictures", "where there is no display, or time matters");
  options.text("decisions", settings.decisions)(
      "with --dry-run write to this JSON file what would be done about each boundary "
      "and junction; else do what it says, after you have changed it",
      "where you know better about one hole or one pair of islands");
}

} // namespace

Usage
repairUsage()
{
  Usage usage;
  usage.program = "pcl_repair_holes";
  usage.synopsis =
      "INPUT_MESH [OUTPUT_MESH] [options]\n"
      "       pcl_repair_holes INPUT_MESH... --output-folder DIR [options]";
  usage.summary =
      R"(Repairs a mesh: turns its islands outside out, joins them by bridges along
force lines and closes the holes, smoothly and in the density of what is
around. All points and triangles of the mesh are kept, with all fields. Points
without a triangle are free points, samples of the missing regions. With
--inspect it shows what is missing. Any mesh will do: it is cut where more than
two triangles meet in an edge.

INPUT_MESH   )" +
      std::string(mesh_endings) + "\nOUTPUT_MESH  " + mesh_output_endings +
      R"(; .ply keeps most; may be left out with
             --inspect and --dry-run
'-' stands for standard input (the first bytes tell the format) and standard output
(PLY unless --format is given); what is for people then goes to standard error.)";
  usage.examples = R"(  pcl_repair_holes scan.ply repaired.ply
  pcl_repair_holes scan.ply repaired.ply --free-points sparse.pcd --report r.json
  pcl_repair_holes scan.ply --dry-run
  pcl_repair_holes a.ply b.ply c.ply --output-folder repaired
  pcl_repair_holes - - < scan.ply | pcl_mesh_quality -
  pcl_repair_holes scan.ply --inspect found --report found.json
  pcl_viewer found/origins.pcd found/islands.vtk found/loops.vtk
)";
  return usage;
}

void
addRepairOptions(CommandLine& command_line, RepairSettings& settings)
{
  addFileNames(command_line,
               {"INPUT_MESH", "OUTPUT_MESH", "--output-folder DIR", nullptr},
               settings.files);
  addRunOptions(command_line.options(), settings);
  addThreads(command_line, settings.threads);
  addFormatOption(command_line, settings.files, " for --output-folder");
  command_line.then([&] { return checkOutputs(command_line, settings); });
  addMethodOptions(command_line, settings.method);
}

void
takeDecisions(RepairSettings& settings)
{
  if (settings.decisions.empty())
    return;
  auto& decisions = settings.method.survey.decisions;
  require(settings.dry_run ? readDecisionsIfAny(settings.decisions, decisions)
                           : readDecisions(settings.decisions, decisions));
}

} // namespace app
