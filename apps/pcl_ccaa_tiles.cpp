// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that meshes clouds of any size step by step.
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/reconstruct_options.h"
#include "io/interrupt.h"
#include "io/text_scanner.h"
#include "out_of_core/partition.h"
#include "out_of_core/shards.h"

#include <iostream>
#include <string>
#include <vector>

namespace app {
namespace {

struct Task {
  std::string step;
  std::string folder;
  std::vector<std::string> rest;
  std::uint64_t most_points = DEFAULT_TILE_POINTS;
  ReconstructSettings settings;
};

Usage
usage()
{
  Usage usage;
  usage.program = "pcl_ccaa_tiles";
  usage.synopsis =
      "cut FOLDER INPUT_CLOUD... [options]\n"
      "       pcl_ccaa_tiles mesh|join|close|wind|repair|shard FOLDER TILE\n"
      "       pcl_ccaa_tiles disputes|sides|holes|numbers|index FOLDER\n"
      "       pcl_ccaa_tiles merge FOLDER OUTPUT_MESH\n"
      "       pcl_ccaa_tiles count|neighbors|seams|regions FOLDER";
  usage.summary =
      R"(One step of the reconstruction of a cloud larger than memory, for a workflow engine that
runs the steps on one machine or many. 'pcl_ccaa_reconstruct --tiles' does all of them.
Each step reads files of FOLDER and writes one file, whole or not at all; a step whose
file is there does nothing. Order: cut, then for all tiles mesh, then join, then once
disputes, then for all tiles close, then wind, then once sides, then for all tiles shard,
then once index; merge makes one PLY file. Where 'cut' was told to --repair, before shard
come once holes, for all tiles repair, and once numbers. 'count' prints the number of tiles; they are
numbered from 0. 'neighbors' prints for each a line with its number of points and the
tiles around it: it is meshed from points of these, joined with their meshes. 'seams',
after disputes, prints which tiles' meshes 'close' reads and, behind a colon, which
closed seams 'wind' reads, and behind another one which 'close' does; 'regions', after
holes, the number of points around the holes that 'repair' works on, and of which tiles
it reads the surface.)";
  usage.examples = R"(  pcl_ccaa_tiles cut work scan1.ply scan2.ply --tiles=2000000
  pcl_ccaa_tiles mesh work 0
)";
  return usage;
}

std::size_t
tileOf(const Task& task, const TilePlan& plan)
{
  std::size_t tile = 0;
  if (task.rest.size() != 1 || !parseNumber(task.rest.front(), tile))
    throw Failure("the step '" + task.step + "' needs the number of a tile");
  if (tile >= plan.tiling.tiles.size())
    throw Failure("there is no tile " + std::to_string(tile) + ": the folder has " +
                  std::to_string(plan.tiling.tiles.size()));
  return tile;
}

void
cut(const Task& task)
{
  if (task.rest.empty())
    throw Failure("the step 'cut' needs clouds to cut");
  checkTileRepair(task.settings.method);
  ProgressBar bar(task.settings.quiet);
  partition(task.rest,
            task.folder,
            task.most_points,
            settingsText(task.settings),
            task.settings.threads,
            [&](double share) { return bar.show("cutting", share); });
}

void
merge(const Task& task, const TilePlan& plan)
{
  if (task.rest.size() != 1)
    throw Failure("the step 'merge' needs the name of a .ply file");
  OutputFile file;
  require(file.open(task.rest.front()));
  mergeTiles(plan, countTriangles(plan), true, file);
  require(file.commit());
}

template <typename Tiles>
void
print(const Tiles& tiles)
{
  for (const std::size_t tile : tiles)
    std::cout << ' ' << tile;
}

void
printNeighbors(const TilePlan& plan)
{
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    std::cout << plan.tiling.tiles[tile].count;
    print(plan.tiling.neighborsOf(tile));
    std::cout << '\n';
  }
}

void
printSeams(const TilePlan& plan)
{
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const SeamLinks links = seamLinks(plan, tile);
    print(links.parts);
    std::cout << " :";
    print(links.closers);
    std::cout << " :";
    print(links.earlier);
    std::cout << '\n';
  }
}

void
printRegions(const TilePlan& plan)
{
  const std::vector<std::uint64_t> points = repairPoints(plan);
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    std::cout << points[tile];
    print(holeParts(plan, tile));
    std::cout << '\n';
  }
}

void
runStep(const Task& task, const TilePlan& plan)
{
  StepRun run;
  run.threads = task.settings.threads;
  run.progress = [](const std::string&, double) { return !interrupted(); };
  const std::string& step = task.step;
  if (step == "count")
    std::cout << plan.tiling.tiles.size() << std::endl;
  else if (step == "neighbors")
    printNeighbors(plan);
  else if (step == "seams")
    printSeams(plan);
  else if (step == "regions")
    printRegions(plan);
  else if (step == "mesh")
    meshTile(plan, tileOf(task, plan), run);
  else if (step == "join")
    joinTile(plan, tileOf(task, plan));
  else if (step == "disputes")
    groupAllDisputes(plan);
  else if (step == "close")
    closeTile(plan, tileOf(task, plan), run);
  else if (step == "wind")
    windTile(plan, tileOf(task, plan), run);
  else if (step == "sides")
    decideAllSides(plan);
  else if (step == "holes")
    findHoles(plan);
  else if (step == "repair")
    repairTile(plan, tileOf(task, plan), run);
  else if (step == "numbers")
    numberRepairs(plan);
  else if (step == "shard")
    writeShard(plan, tileOf(task, plan));
  else if (step == "index")
    writeIndex(plan);
  else if (step == "merge")
    merge(task, plan);
  else
    throw Failure("there is no step '" + step + "' (try --help)");
}

Outcome
run(const Task& task)
{
  if (task.step == "cut")
    cut(task);
  else
    runStep(task, readPlan(task.folder));
  return interrupted() ? Outcome{INTERRUPTED, stopped_by_signal, {}} : Outcome();
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::Task task;
  app::CommandLine line(app::usage(), task.settings.quiet);
  line.positional("STEP", task.step);
  line.positional("FOLDER", task.folder);
  line.morePositionals("ARGUMENT", task.rest);
  line.options().count("tiles", task.most_points, app::LEAST_TILE_POINTS, 1000000000)(
      "with 'cut': most points at a time; where a cloud has more, a tile has about a "
      "quarter of that",
      "lower for machines with little memory");
  app::addThreads(line, task.settings.threads);
  app::addChainOptions(line, task.settings);
  app::addRepairWishes(line, task.settings);
  return app::runApp(line, argc, argv, [&] { return app::run(task); });
}
