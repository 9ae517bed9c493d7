// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_ccaa_reconstruct.
#include "reconstruct_options.h"

#include "io/text_scanner.h"
#include "method_options.h"

#include <cmath>
#include <string_view>

namespace app {
namespace {

const Word<std::string> STAGES[] = {
    {"start", "start"}, {"filter", "filter"}, {"base", "base"}};
constexpr double LONGEST = 1e30; // of lengths
const Word<std::string> STARTS[] = {
    {"auto", "auto"}, {"greedy", "greedy"}, {"grid", "grid"}};
/** A number of bytes with K, M, G or T behind it. */
std::uint64_t
bytesOf(const std::string& text)
{
  constexpr std::string_view UNITS = "KMGT";
  std::string digits = text;
  double unit = 1.0;
  if (const auto place =
          text.empty() ? std::string_view::npos : UNITS.find(text.back());
      place != std::string_view::npos) {
    unit = std::pow(1024.0, double(place + 1));
    digits.pop_back();
  }
  double number = 0.0;
  if (!parseNumber(digits, number) || !(number * unit >= 1.0) || number * unit > 1e18)
    throw Failure("--memory must be a number of bytes such as 500M or 4G, not '" +
                  text + "'");
  return static_cast<std::uint64_t>(number * unit);
}

const Word<std::string> SEARCHES[] = {{"fast", "fast"}, {"kdtree", "kdtree"}};

void
addCleaning(OptionGroup& options, ReconstructSettings& settings)
{
  options.flag("clean", settings.clean)(
      "first make one even layer of the points: grid, outliers away, smoothing; the "
      "points are new ones then",
      "for noise, and for scans that overlap and disagree");
  options.real("clean-spacing", settings.cleaning.spacing, 0, LONGEST)(
      "distance that points keep in --clean, in units of the cloud; 0: as dense as the "
      "cloud",
      "for a coarser mesh");
  options.real("clean-radius", settings.cleaning.radius, 0, LONGEST)(
      "radius of the patches that smooth in --clean, in units of the cloud; what is "
      "smaller goes; 0: by the noise",
      "greater where the mesh is still rough, less where edges are rounded off");
  options.real("clean-outliers", settings.cleaning.outlier_deviations, 1, 1000)(
      "how many standard deviations farther than usual neighbours of an outlier are",
      "lower where strays are left, higher where thin parts vanish");
}

void
addOutputs(OptionGroup& options, ReconstructSettings& settings)
{
  options.flag("merge", settings.merge)(
      "all inputs are views of one object and become one cloud, in which each point "
      "keeps the viewpoint of its file",
      "for registered scans from several places");
  addCleaning(options, settings);
  options.flag("labels", settings.labels)(
      "write which stage made each triangle as the face property 'stage': 0 start, 1 "
      "base, 2 repair; PLY only",
      "to tell what was measured from what was added");
  options.flag("normals", settings.normals)(
      "write a normal of the surface for each point, unless the cloud has normals",
      "for viewers and programs that want them");
  options.flag("dry-run", settings.dry_run)(
      "say what would be read and how, and write nothing but the report",
      "to see how an unknown scan is understood");
  options.text("report", settings.files.report)(
      "write figures about the run to this JSON file, or to standard output (-)",
      "where a program goes on with the figures");
}

void
addStageOptions(OptionGroup& options, ReconstructSettings& settings)
{
  options.choice("until", settings.until, STAGES)(
      "last stage: start (raw triangles, some of them wrong, wound in any way), filter "
      "(correct triangles only) or base (what is missing between them, too)",
      "to look at a stage, or to go on by other means");
  options.choice("start", settings.start, STARTS)(
      "which points the first triangles join: greedy (near ones), grid (neighbours in "
      "rows and columns of an organised cloud) or auto (of these the one that leaves "
      "fewer islands)",
      "as grid for depth cameras whose steps of depth are wider than their pixels");
  options.flag("measure-speedup", settings.measure_speedup)(
      "also run the base stage alone, and print whether the stages before it pay",
      "to judge the method on data of your kind");
  options.choice("search", settings.search, SEARCHES)(
      "neighbour search: fast, or kdtree (PCL's own)", "to compare their times");
}

void
addGreedyOptions(OptionGroup& options, ReconstructSettings& settings)
{
  options.count("neighbors", settings.neighbors, 3, 64)(
      "neighbours looked at for each point, 3 to 64",
      "higher where density changes within a few points");
  options.real("min-angle", settings.minimum_angle, 0, 60)(
      "smallest angle between two edges at a point, in degrees, 0 to 60",
      "lower where narrow triangles are better than holes");
  options.real("certified-angle", settings.certified_minimum_angle, 0, 60)(
      "the same for edges that no other point speaks against, in degrees, 0 to 60",
      "higher against slivers");
  options.real("max-length", settings.length_factor, 1, 1e6)(
      "longest edge as a multiple of the spacing around it, 1 or more",
      "higher where thin regions stay open, lower where separate parts get joined");
  options.flag("plain", settings.plain)(
      "shortest edges first and --min-angle alone, without asking for each edge "
      "whether other points speak against it; faults and holes are more",
      "to compare with the thesis");
  options.count("min-region", settings.minimum_internal_points, 0, 1000000000)(
      "regions with fewer inner points than this are removed by the filter; 0 keeps "
      "all",
      "at 0 where small separate parts are wanted, higher where strays form crumbs");
}

void
addTileOptions(OptionGroup& options, ReconstructSettings& settings)
{
  options.optionalCount(
      "tiles", settings.tiles, DEFAULT_TILE_POINTS, LEAST_TILE_POINTS, 1000000000)(
      "work tile by tile: at most so many points at a time, 4 000 000 when it is just "
      "--tiles; where a cloud has more, a tile has about a quarter of that; all inputs "
      "are one cloud, OUTPUT_MESH is PLY",
      "for clouds larger than memory");
  options.parsed(
      "memory",
      [&settings](const std::string& text) { settings.memory = bytesOf(text); },
      "4G")("with --tiles: memory for tiles that are worked on at a time, such as 500M "
            "or 4G; the result is the same for any",
            "where other programs need memory, too");
  options.text("tile-folder", settings.tile_folder)(
      "with --tiles: keep the tiles as shards, one PLY each with an index, in this "
      "folder; a run that was stopped goes on there. With one input OUTPUT_MESH may be "
      "left out",
      "for long runs, and for maps that are read piece by piece");
}

void
checkTiles(const ReconstructSettings& settings)
{
  if (settings.tiles == 0 && !settings.tile_folder.empty())
    throw Failure("--tile-folder needs --tiles");
  if (settings.tiles == 0)
    return;
  const FileNames& files = settings.files;
  if (settings.labels || settings.normals || settings.until != "base" ||
      settings.measure_speedup || settings.search != "fast" || files.isBatch() ||
      settings.dry_run)
    throw Failure("--tiles makes the mesh of the stage base and nothing else; it does "
                  "not go with --labels, --normals, --until, "
                  "--measure-speedup, --search, --dry-run, --clean, --start grid and "
                  "--output-folder");
  if (!files.output.empty() && files.target().format != FileFormat::PLY)
    throw Failure("--tiles writes PLY, not '" + files.output + "'");
  checkTileRepair(settings.method);
}

void
checkFiles(const ReconstructSettings& settings)
{
  const FileNames& files = settings.files;
  if (files.isBatch() && settings.merge)
    throw Failure("--merge makes one mesh, --output-folder one of each input; they do "
                  "not go together");
  if (!files.isBatch() && files.output.empty() && !settings.dry_run &&
      settings.tile_folder.empty())
    throw Failure("OUTPUT_MESH is missing (try --help)");
  if (settings.labels && !settings.dry_run && !holdsFaceProperties(files.target()))
    throw Failure("--labels needs an output that ends in .ply, not '" + files.output +
                  "'");
}

void
checkStages(const ReconstructSettings& settings)
{
  if (settings.measure_speedup && settings.until != "base")
    throw Failure(
        "--measure-speedup compares with the stage base; it does not go with --until " +
        settings.until);
  if (settings.repair && settings.until != "base")
    throw Failure(
        "--repair closes what the stage base leaves; it does not go with --until " +
        settings.until);
  if (settings.normals && settings.until == "start")
    throw Failure("--normals needs triangles that are wound alike; it does not go with "
                  "--until start");
}

/** What belongs to another option matters only with that. */
void
checkNeeds(const CommandLine& line, const ReconstructSettings& settings)
{
  for (const char* name : {"clean-spacing", "clean-radius", "clean-outliers"})
    if (!settings.clean && line.given(name))
      throw Failure("--" + std::string(name) + " needs --clean");
  if (settings.labels && line.given("drop-islands"))
    throw Failure("--labels tells the stage of each triangle that the reconstruction "
                  "made; it does not go with --drop-islands");
}

void
checkWishes(const CommandLine& line, const ReconstructSettings& settings)
{
  for (const char* name : {"close",
                           "watertight",
                           "cap",
                           "drop-islands",
                           "greatest-hole",
                           "greatest-hole-length",
                           "greatest-bridge"})
    if (!settings.repair && line.given(name))
      throw Failure("--" + std::string(name) + " needs --repair");
}

} // namespace

void
checkTileRepair(const pcl::repair::RepairParameters& method)
{
  if (method.survey.dropped.any())
    throw Failure("--drop-islands asks for whole islands; it does not go with tiles");
  if (method.filling.greatest_length.of_diagonal ||
      method.survey.greatest_bridge.of_diagonal)
    throw Failure("with tiles lengths are in units of the cloud, not shares of it");
}

Usage
reconstructUsage()
{
  Usage usage;
  usage.program = "pcl_ccaa_reconstruct";
  usage.synopsis =
      "INPUT_CLOUD OUTPUT_MESH [options]\n"
      "       pcl_ccaa_reconstruct INPUT_CLOUD... -o OUTPUT_MESH --merge [options]\n"
      "       pcl_ccaa_reconstruct INPUT_CLOUD... --output-folder DIR [options]";
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
  pcl_ccaa_reconstruct front.pcd left.pcd back.pcd --merge --clean -o bust.ply
  pcl_ccaa_reconstruct - - < bunny.pcd | pcl_repair_holes - bunny.ply
  pcl_ccaa_reconstruct bunny.pcd bunny.ply --labels --normals --measure-speedup
)";
  return usage;
}

void
addChainOptions(CommandLine& command_line, ReconstructSettings& settings)
{
  addSideOptions(command_line, settings.sides);
  addGreedyOptions(command_line.method(), settings);
}

void
addRepairWishes(CommandLine& command_line, ReconstructSettings& settings)
{
  command_line.options().flag("repair", settings.repair)(
      "then join the islands and close the holes, as pcl_repair_holes does",
      "for a finished model, not only what was measured");
  addWishOptions(command_line, settings.method);
  command_line.then([&] { return checkWishes(command_line, settings); });
}

void
addReconstructOptions(CommandLine& command_line, ReconstructSettings& settings)
{
  addFileNames(command_line,
               {"INPUT_CLOUD",
                "OUTPUT_MESH",
                "--merge and -o/--output OUTPUT_MESH, or --output-folder DIR",
                &settings.merge,
                &settings.tile_folder},
               settings.files);
  addOutputs(command_line.options(), settings);
  addThreads(command_line, settings.threads);
  addTileOptions(command_line.options(), settings);
  addRepairWishes(command_line, settings);
  addFormatOption(command_line, settings.files, "");
  addStageOptions(command_line.method(), settings);
  addChainOptions(command_line, settings);
  command_line.then([&] { return checkFiles(settings); });
  command_line.then([&] { return checkTiles(settings); });
  command_line.then([&] { return checkStages(settings); });
  command_line.then([&] { return checkNeeds(command_line, settings); });
}

} // namespace app
