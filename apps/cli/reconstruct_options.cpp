// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_ccaa_reconstruct.
#include "reconstruct_options.h"

#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/point_types.h>

#include "file_names.h"
#include "io/model_io.h"
#include "side_options.h"
#include "wish_options.h"

#include <cmath>

namespace app {
namespace {

namespace po = boost::program_options;

Usage
usage()
{
  Usage usage;
  usage.program = "pcl_ccaa_reconstruct";
  usage.synopsis = "INPUT_CLOUD OUTPUT_MESH [options]\n"
                   "       pcl_ccaa_reconstruct INPUT_CLOUD... -o OUTPUT_MESH --merge "
                   "[options]\n"
                   "       pcl_ccaa_reconstruct INPUT_CLOUD... --output-folder DIR "
                   "[options]";
  usage.summary =
      R"(Connects the points of a cloud with triangles. Needs no normals and no settings. The
mesh keeps all points of the cloud, in order and with all fields (colours, normals,
intensity, ...); points no triangle could be trusted with stay without triangles.

INPUT_CLOUD   )" +
      std::string(cloud_endings) + R"(;
              of a mesh only the points are read
OUTPUT_MESH   )" +
      mesh_output_endings + R"(; .ply keeps most
'-' stands for standard input (the first bytes tell the format) and standard output
(PLY unless --format is given); what is for people then goes to standard error.)";
  usage.examples = R"(  pcl_ccaa_reconstruct bunny.pcd bunny.ply
  pcl_ccaa_reconstruct scan.xyz scan.ply --threads 4 --report scan.json
  pcl_ccaa_reconstruct bunny.pcd bunny.ply --repair
  pcl_ccaa_reconstruct front.pcd left.pcd back.pcd --merge -o bust.ply
  pcl_ccaa_reconstruct - - < bunny.pcd | pcl_repair_holes - bunny.ply
  pcl_ccaa_reconstruct bunny.pcd bunny.ply --labels --normals --measure-speedup
)";
  return usage;
}

po::typed_value<std::string>*
text()
{
  return po::value<std::string>();
}

po::typed_value<long long>*
count(long long default_value)
{
  return po::value<long long>()->default_value(default_value);
}

void
addOutputs(po::options_description_easy_init add)
{
  add("repair",
      po::bool_switch(),
      "then join the islands and close the holes, as pcl_repair_holes does");
  add("merge",
      po::bool_switch(),
      "all inputs are views of one object and become one cloud, in which each point "
      "keeps the viewpoint of its file");
  add("labels",
      po::bool_switch(),
      "write which stage made each triangle as the face property 'stage': 0 start, "
      "1 base, 2 repair; PLY only");
  add("normals",
      po::bool_switch(),
      "write a normal of the surface for each point, unless the cloud has normals");
  add("dry-run",
      po::bool_switch(),
      "say what would be read and how, and write nothing but the report");
  add("report",
      text(),
      "write figures about the run to this JSON file, or to standard output (-)");
  add("threads",
      count(0),
      "number of threads, 0 = all; the result is the same for any");
}

void
addSettings(po::options_description_easy_init add)
{
  const pcl::GreedyStart<pcl::PointXYZ> start;
  const pcl::UmbrellaFilter filter;
  const auto degrees = [](double angle) {
    return std::round(angle * 18000 / M_PI) / 100;
  };
  add("until",
      text()->default_value("base"),
      "last stage: start (raw triangles, some of them wrong, wound in any way), filter "
      "(correct triangles only) or base (what is missing between them, too)");
  add("measure-speedup",
      po::bool_switch(),
      "also run the base stage alone, and print whether the stages before it pay");
  add("search",
      text()->default_value("fast"),
      "neighbour search: fast, or kdtree (PCL's own)");
  add("neighbors",
      count(start.getNumberOfNeighbors()),
      "neighbours looked at for each point, 3 to 64");
  add("min-angle",
      realValue(degrees(start.getMinimumAngle())),
      "smallest angle between two edges at a point, in degrees, 0 to 60");
  add("certified-angle",
      realValue(degrees(start.getCertifiedMinimumAngle())),
      "the same for edges that no other point speaks against, in degrees, 0 to 60");
  add("max-length",
      realValue(start.getLengthFactor()),
      "longest edge as a multiple of the spacing around it, 1 or more");
  add("plain",
      po::bool_switch(),
      "shortest edges first and --min-angle alone, without asking for each edge "
      "whether other points speak against it; faults and holes are more");
  add("min-region",
      count(static_cast<long long>(filter.getMinimumInternalPoints())),
      "regions with fewer inner points than this are removed by the filter; 0 keeps "
      "all");
}

Status
takeFiles(const Arguments& arguments, ReconstructSettings& settings)
{
  const FileRules rules{"INPUT_CLOUD",
                        "OUTPUT_MESH",
                        "--merge and -o/--output OUTPUT_MESH, or --output-folder DIR",
                        settings.merge};
  FileNames names;
  Status status = takeFileNames(arguments, rules, names);
  if (!status.ok())
    return status;
  const bool is_many = names.isBatch();
  if (is_many && settings.merge)
    return Status::error("--merge makes one mesh, --output-folder one of each input; "
                         "they do not go together");
  if (!is_many && names.output.empty() && !settings.dry_run)
    return Status::error("OUTPUT_MESH is missing (try --help)");
  settings.input = names.inputs.front();
  settings.inputs = std::move(names.inputs);
  settings.output = std::move(names.output);
  settings.output_folder = std::move(names.folder);
  const bool is_needed = is_many || isStandardStream(settings.output);
  status = takeFormat(arguments, is_needed, settings.format);
  if (is_many && settings.format == FileFormat::UNKNOWN)
    settings.format = FileFormat::PLY;
  if (status.ok() && is_many && !isMeshOutput(Target("", settings.format)))
    return Status::error("--format must be one of ply, vtk, obj, off and stl");
  return status;
}

Status
checkChoices(const ReconstructSettings& settings)
{
  if (settings.until != "start" && settings.until != "filter" &&
      settings.until != "base")
    return Status::error("--until must be start, filter or base, not '" +
                         settings.until + "'");
  if (settings.search != "fast" && settings.search != "kdtree")
    return Status::error("--search must be fast or kdtree, not '" + settings.search +
                         "'");
  if (settings.measure_speedup && settings.until != "base")
    return Status::error("--measure-speedup compares with the stage base; it does not "
                         "go with --until " +
                         settings.until);
  if (settings.repair && settings.until != "base")
    return Status::error("--repair closes what the stage base leaves; it does not go "
                         "with --until " +
                         settings.until);
  if (settings.normals && settings.until == "start")
    return Status::error("--normals needs triangles that are wound alike; it does not "
                         "go with --until start");
  const Target target =
      settings.output_folder.empty() ? settings.target() : Target("", settings.format);
  if (settings.labels && !settings.dry_run && !holdsFaceProperties(target))
    return Status::error("--labels needs an output that ends in .ply, not '" +
                         settings.output + "'");
  return {};
}

/** What is to be closed matters only where something is closed. */
Status
checkNeedsRepair(const Arguments& arguments, const ReconstructSettings& settings)
{
  for (const char* name : {"close",
                           "watertight",
                           "cap",
                           "drop-islands",
                           "greatest-hole",
                           "greatest-hole-length",
                           "greatest-bridge"})
    if (!settings.repair && arguments.count(name) != 0 && !arguments[name].defaulted())
      return Status::error("--" + std::string(name) + " needs --repair");
  if (settings.labels && arguments.count("drop-islands") != 0)
    return Status::error("--labels tells the stage of each triangle that the "
                         "reconstruction made; it does not go with --drop-islands");
  return {};
}

} // namespace

CommandLine
makeReconstructCommandLine()
{
  CommandLine line(usage());
  addFileNames(line, "INPUT_CLOUD", "OUTPUT_MESH");
  addOutputs(line.addOptions());
  addSideOptions(line);
  addWishOptions(line);
  addFormatOption(line, "ply, vtk, obj, off or stl");
  addSettings(line.addMethodOptions());
  return line;
}

Status
takeReconstructSettings(const Arguments& arguments, ReconstructSettings& settings)
{
  settings.report = takeText(arguments, "report");
  settings.until = takeText(arguments, "until");
  settings.search = takeText(arguments, "search");
  settings.plain = arguments["plain"].as<bool>();
  settings.labels = arguments["labels"].as<bool>();
  settings.repair = arguments["repair"].as<bool>();
  settings.normals = arguments["normals"].as<bool>();
  settings.measure_speedup = arguments["measure-speedup"].as<bool>();
  settings.quiet = arguments.count("quiet") != 0;
  settings.merge = arguments["merge"].as<bool>();
  settings.dry_run = arguments["dry-run"].as<bool>();
  Status status = takeFiles(arguments, settings);
  if (status.ok())
    status = checkChoices(settings);
  if (status.ok())
    status = takeSides(arguments, settings.sides);
  if (status.ok())
    status = takeCount(arguments, "threads", 0, 1024, settings.threads);
  if (status.ok())
    status = takeCount(arguments, "neighbors", 3, 64, settings.neighbors);
  if (status.ok())
    status = takeCount(
        arguments, "min-region", 0, 1000000000, settings.minimum_internal_points);
  if (status.ok())
    status = takeReal(arguments, "min-angle", 0, 60, settings.minimum_angle);
  if (status.ok())
    status =
        takeReal(arguments, "certified-angle", 0, 60, settings.certified_minimum_angle);
  if (status.ok())
    status = takeReal(arguments, "max-length", 1, 1e6, settings.length_factor);
  if (status.ok())
    status = takeWishes(arguments, settings.method);
  if (status.ok())
    status = checkNeedsRepair(arguments, settings);
  return status;
}

} // namespace app
