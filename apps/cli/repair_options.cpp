// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_holes.
#include "repair_options.h"

#include "file_names.h"
#include "io/decisions_file.h"
#include "io/model_io.h"
#include "side_options.h"
#include "wish_options.h"

#include <limits>

namespace app {
namespace {

namespace po = boost::program_options;
using pcl::repair::DarningChoice;
using pcl::repair::FieldMode;
using pcl::repair::FieldParameters;
using pcl::repair::RepairParameters;
using pcl::repair::SurveyParameters;

constexpr double LARGEST = 1e30; // of lengths, which have the units of the cloud
constexpr double BELOW_ONE = 1.0 - std::numeric_limits<double>::epsilon();

/** Least value of what has to be above 0. */
constexpr double ABOVE_ZERO = 1e-6;

/** \brief An option of the method with one real number. */
struct RealOption {
  const char* name;
  const char* help;
  double lowest;
  double highest;
  double FieldParameters::*value;
};

constexpr RealOption FIELD_OPTIONS[] = {
    {"interpolation",
     "k_i: how much more a boundary counts for places straight ahead of it, 0 or more",
     0.0,
     1000.0,
     &FieldParameters::interpolation},
    {"falloff-exponent",
     "chi: how fast the field falls off with distance, above 0; 1.7 for long wide gaps",
     ABOVE_ZERO,
     100.0,
     &FieldParameters::falloff_exponent},
    {"near",
     "L1: distance up to which it does not, units of the cloud; 0: the mean spacing of "
     "boundary points",
     0.0,
     LARGEST,
     &FieldParameters::near},
    {"far",
     "L2: distance from which there is no field; 0: --room times the gap at each place",
     0.0,
     LARGEST,
     &FieldParameters::far},
    {"room",
     "gaps that L2 spans, above 1",
     1.0 + ABOVE_ZERO,
     1e6,
     &FieldParameters::room},
    {"free-point-near",
     "R1: the same as L1 for the influence of a free point; 0: their mean spacing",
     0.0,
     LARGEST,
     &FieldParameters::free_point_near},
    {"free-point-far",
     "R2: the same as L2 for it; 0: half the mean gap",
     0.0,
     LARGEST,
     &FieldParameters::free_point_far},
    {"free-point-exponent",
     "gamma: how fast it falls off, above 0",
     ABOVE_ZERO,
     100.0,
     &FieldParameters::free_point_exponent},
    {"trust",
     "k_t: how far free points are to be trusted, 0 to less than 1",
     0.0,
     BELOW_ONE,
     &FieldParameters::trust},
};

struct ChoiceName {
  const char* name;
  DarningChoice choice;
};

constexpr ChoiceName DARNING_CHOICES[] = {
    {"automatic", DarningChoice::AUTOMATIC},
    {"fan", DarningChoice::FAN},
    {"minimum-weight", DarningChoice::MINIMUM_WEIGHT},
    {"completion", DarningChoice::COMPLETION},
};

void
addRunOptions(po::options_description_easy_init add)
{
  const auto path = [] { return po::value<std::string>(); };
  add("free-points", path(), "a cloud of points of the missing regions");
  add("dry-run",
      "say what would be repaired, and write nothing but the report; exit code 0: "
      "nothing to do, 2: something");
  add("report",
      path(),
      "write figures about the model to this JSON file, or to standard output (-)");
  add("labels",
      "write how each triangle came about as the face property 'origin': 0 input, "
      "1 fan, 2 minimum weight, 3 completion; PLY only");
  add("bridges",
      path(),
      "write the bridges that were built, with normals and quality, to this .vtk file");
  add("inspect",
      path(),
      "write what was found to this folder (made if missing): .vtk and .pcd files for "
      "pcl_viewer, PNG pictures, and legend.txt, which explains them");
  add("no-pictures", "leave out the pictures");
  add("decisions",
      path(),
      "with --dry-run write to this JSON file what would be done about each boundary "
      "and junction; else do what it says, after you have changed it");
  add("threads",
      po::value<long long>()->default_value(0),
      "number of threads, 0 = all; the result is the same for any");
}

void
addSurveyOptions(po::options_description_easy_init add)
{
  const SurveyParameters defaults;
  add("mode",
      po::value<std::string>()->default_value("light"),
      "light: distances as they are; full: free points shorten ways and the surface "
      "stands in the way (slower)");
  for (const RealOption& option : FIELD_OPTIONS)
    add(option.name, realValue(defaults.field.*option.value), option.help);
  add("simple-edges",
      po::value<long long>()->default_value(
          static_cast<long long>(defaults.simple_edges)),
      "holes of up to so many edges are simple: they are closed without being divided");
  add("hole-threshold",
      realValue(defaults.hole_threshold),
      "T: within a hole no line ends nearer to its origin than this share of the "
      "boundary's length, above 0 to 0.5");
  add("line-spacing",
      realValue(defaults.line_spacing),
      "least distance between the origins of force lines, in gaps, above 0");
  add("bridge-spacing",
      realValue(defaults.bridge_spacing),
      "least distance between bridges, in lengths of the bridge, above 0");
}

/** How they are closed. */
void
addDarningOptions(po::options_description_easy_init add)
{
  const RepairParameters defaults;
  add("darning",
      po::value<std::string>()->default_value("automatic"),
      "how simple holes are closed: fan (from the centroid), minimum-weight, "
      "completion (base algorithm, with free points as vertices), or automatic: "
      "completion where a hole holds enough free points, else minimum-weight");
  add("edge-length",
      realValue(defaults.refinement.edge_length),
      "edges of new triangles, in those of the surface around, above 0");
  add("no-refine",
      "do not make new triangles as small as those around; not fair either");
  add("no-fair", "do not move new vertices to a smooth surface");
  add("pure", "the thesis alone: --darning fan --no-refine");
}

Status
takeMode(const std::string& text, FieldMode& mode)
{
  if (text != "light" && text != "full")
    return Status::error("--mode must be light or full, not '" + text + "'");
  mode = text == "full" ? FieldMode::FULL : FieldMode::LIGHT;
  return {};
}

/** What the field and other steps of the method have in common. */
void
shareParameters(SurveyParameters& parameters)
{
  parameters.orientation.room = parameters.field.room;
  parameters.tracker.room = parameters.field.room;
}

Status
takeSurveyParameters(const Arguments& arguments, SurveyParameters& parameters)
{
  Status status = takeMode(takeText(arguments, "mode"), parameters.field.mode);
  for (const RealOption& option : FIELD_OPTIONS)
    if (status.ok())
      status = takeReal(arguments,
                        option.name,
                        option.lowest,
                        option.highest,
                        parameters.field.*option.value);
  unsigned int simple_edges = 0;
  if (status.ok())
    status = takeCount(arguments, "simple-edges", 0, 1000000000, simple_edges);
  parameters.simple_edges = simple_edges;
  if (status.ok())
    status = takeReal(
        arguments, "hole-threshold", ABOVE_ZERO, 0.5, parameters.hole_threshold);
  if (status.ok())
    status =
        takeReal(arguments, "line-spacing", ABOVE_ZERO, 1e6, parameters.line_spacing);
  if (status.ok())
    status = takeReal(
        arguments, "bridge-spacing", ABOVE_ZERO, 1e6, parameters.bridge_spacing);
  shareParameters(parameters);
  return status;
}

Status
takeDarning(const std::string& text, DarningChoice& choice)
{
  std::string names;
  for (const ChoiceName& named : DARNING_CHOICES) {
    if (text == named.name) {
      choice = named.choice;
      return {};
    }
    names += (names.empty() ? "" : ", ") + std::string(named.name);
  }
  return Status::error("--darning must be one of " + names + ", not '" + text + "'");
}

/** What is done about the holes, the field aside. */
Status
takeClosingParameters(const Arguments& arguments, RepairParameters& parameters)
{
  Status status =
      takeDarning(takeText(arguments, "darning"), parameters.darning.choice);
  if (status.ok())
    status = takeReal(
        arguments, "edge-length", ABOVE_ZERO, 1e6, parameters.refinement.edge_length);
  const bool pure = arguments.count("pure") != 0;
  if (pure)
    parameters.darning.choice = DarningChoice::FAN;
  if (!arguments["simple-edges"].defaulted())
    parameters.darning.simple_edges = parameters.survey.simple_edges;
  parameters.join_islands = arguments.count("no-join") == 0;
  parameters.refine = !pure && arguments.count("no-refine") == 0;
  parameters.relax = parameters.refine && arguments.count("no-fair") == 0;
  return status;
}

Status
checkManyInputs(const RepairSettings& settings)
{
  if (!settings.inspect.empty() || !settings.bridges.empty() ||
      !settings.decisions.empty())
    return Status::error("--inspect, --bridges and --decisions are about one model; "
                         "they do not go with --output-folder");
  const Target target("", settings.format);
  if (!isMeshOutput(target))
    return Status::error("--format for --output-folder must be one of ply, vtk, obj, "
                         "off and stl");
  if (settings.labels && !holdsFaceProperties(target))
    return Status::error("--labels needs --format ply");
  return {};
}

/** Options that do not go together, or ask for nothing. */
Status
checkOutputs(const RepairSettings& settings)
{
  if (!settings.repairs() && !settings.surveys() && settings.inputs.empty())
    return Status::error("nothing is asked for: name an OUTPUT_MESH for the repaired "
                         "surface, or use --inspect DIR or --dry-run to see what is "
                         "missing (try --help)");
  if (settings.dry_run && !settings.inspect.empty())
    return Status::error("--dry-run writes nothing but the report; it does not go with "
                         "--inspect");
  if (!settings.inputs.empty())
    return checkManyInputs(settings);
  if (settings.output.empty() && (!settings.bridges.empty() || settings.labels))
    return Status::error("--bridges and --labels tell about a repair; they need an "
                         "OUTPUT_MESH");
  if (settings.output.empty() && !settings.dry_run && !settings.decisions.empty())
    return Status::error("--decisions is written with --dry-run and read with an "
                         "OUTPUT_MESH");
  if (settings.labels && !holdsFaceProperties(settings.target()))
    return Status::error("--labels needs an output that ends in .ply, not '" +
                         settings.output + "'");
  return {};
}

Status
takeFiles(const Arguments& arguments, RepairSettings& settings)
{
  FileNames names;
  Status status = takeFileNames(
      arguments, {"INPUT_MESH", "OUTPUT_MESH", "--output-folder DIR", false}, names);
  if (!status.ok())
    return status;
  settings.input = names.inputs.front();
  settings.output = std::move(names.output);
  settings.output_folder = std::move(names.folder);
  const bool is_many = !settings.output_folder.empty();
  if (is_many)
    settings.inputs = std::move(names.inputs);
  status = takeFormat(
      arguments, is_many || isStandardStream(settings.output), settings.format);
  if (is_many && settings.format == FileFormat::UNKNOWN)
    settings.format = FileFormat::PLY;
  return status;
}

} // namespace

const char*
nameOf(DarningChoice choice)
{
  for (const ChoiceName& named : DARNING_CHOICES)
    if (named.choice == choice)
      return named.name;
  return "";
}

void
addRepairOptions(CommandLine& command_line)
{
  addFileNames(command_line, "INPUT_MESH", "OUTPUT_MESH");
  addRunOptions(command_line.addOptions());
  addFormatOption(command_line, "ply, vtk, obj, off or stl");
  addMethodOptions(command_line);
}

void
addMethodOptions(CommandLine& command_line)
{
  addSideOptions(command_line);
  command_line.addOptions()("no-join", "leave islands apart");
  addWishOptions(command_line);
  addDarningOptions(command_line.addMethodOptions());
  addSurveyOptions(command_line.addMethodOptions());
}

Status
takeMethod(const Arguments& arguments, RepairParameters& method)
{
  Status status = takeSides(arguments, method.survey.orientation.sides);
  if (status.ok())
    status = takeSurveyParameters(arguments, method.survey);
  if (status.ok())
    status = takeClosingParameters(arguments, method);
  return status.ok() ? takeWishes(arguments, method) : status;
}

Status
takeDecisions(RepairSettings& settings)
{
  if (settings.decisions.empty())
    return {};
  return settings.dry_run
             ? readDecisionsIfAny(settings.decisions, settings.method.survey.decisions)
             : readDecisions(settings.decisions, settings.method.survey.decisions);
}

Status
takeRepairSettings(const Arguments& arguments, RepairSettings& settings)
{
  settings.inspect = takeText(arguments, "inspect");
  settings.free_points = takeText(arguments, "free-points");
  settings.report = takeText(arguments, "report");
  settings.decisions = takeText(arguments, "decisions");
  settings.pictures = arguments.count("no-pictures") == 0;
  settings.quiet = arguments.count("quiet") != 0;
  settings.bridges = takeText(arguments, "bridges");
  settings.labels = arguments.count("labels") != 0;
  settings.dry_run = arguments.count("dry-run") != 0;
  if (arguments.count("inspect") != 0 && settings.inspect.empty())
    return Status::error("--inspect needs the name of a folder");
  Status status = takeFiles(arguments, settings);
  if (status.ok())
    status = checkOutputs(settings);
  if (status.ok())
    status = takeCount(arguments, "threads", 0, 1024, settings.threads);
  if (status.ok())
    status = takeMethod(arguments, settings.method);
  return status;
}

} // namespace app
