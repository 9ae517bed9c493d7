// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps that repair what the tiles have left open.
#include "cli/repair_run.h"
#include "mesh/disjoint_sets.h"
#include "mesh/sort_unique.h"
#include "out_of_core/cluster_repair.h"
#include "out_of_core/hole_gathering.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_points.h"
#include "out_of_core/tile_steps.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** The points of some edges, ascending, and where they are. */
void
placesOf(const TilePlan& plan,
         const std::vector<pcl::ccaa::OpenEdge>& edges,
         std::vector<WideIndex>& points,
         std::vector<Position>& positions)
{
  for (const pcl::ccaa::OpenEdge& edge : edges)
    points.insert(points.end(), edge.ends.begin(), edge.ends.end());
  pcl::ccaa::sortUnique(points);
  forPoints(plan,
            points.begin(),
            points.end(),
            [&](std::size_t, const TilePoints& tile, std::size_t i) {
              positions.push_back(tile.position(i));
            });
}

std::vector<pcl::ccaa::TilePieces>
readAllSums(const TilePlan& plan)
{
  std::vector<pcl::ccaa::TilePieces> tiles;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
    tiles.push_back(readPiecesSums(plan, tile));
  return tiles;
}

/** The method as the user wants it, with what is known of the whole. What needs the
 * whole is judged for all tiles together. */
pcl::repair::RepairParameters
methodFor(const TilePlan& plan)
{
  const ReconstructSettings settings = settingsOf(plan);
  pcl::repair::RepairParameters method = settings.method;
  pcl::ccaa::SideHints sides = sidesOf(settings.sides, plan.viewpoint);
  if (const int axis = readSides(plan).tally.guessed_axis; axis >= 0) {
    sides.up = Eigen::Vector3d::Unit(axis);
    sides.up_is_guessed = true;
  }
  method.survey.orientation.sides = sides;
  method.greatest_unsupported = 1.0;
  return method;
}

} // namespace

void
findHoles(const TilePlan& plan)
{
  if (isDone(plan.file(HOLES_FILE), plan.key))
    return;
  const pcl::ccaa::Sides sides = readSides(plan);
  const std::vector<pcl::ccaa::TilePieces> tiles = readAllSums(plan);
  std::vector<pcl::ccaa::OpenEdge> edges = openEdges(tiles, sides);
  std::vector<WideIndex> points;
  std::vector<Position> positions;
  placesOf(plan, edges, points, positions);
  std::vector<pcl::ccaa::OpenLoop> loops = clusterLoops(edges,
                                                        points,
                                                        positions,
                                                        sumUpComponents(tiles, sides),
                                                        plan.tiling,
                                                        plan.most_points);
  AllHoles holes;
  for (const pcl::ccaa::OpenEdge& edge : edges)
    holes.edges.push_back(edge.ends);
  std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    return a.cluster < b.cluster;
  });
  for (const pcl::ccaa::OpenLoop& loop : loops) {
    holes.borders += loop.use == pcl::ccaa::LoopUse::BORDER ? 1 : 0;
    holes.beyond += loop.use == pcl::ccaa::LoopUse::BEYOND ? 1 : 0;
    if (loop.use != pcl::ccaa::LoopUse::REPAIR)
      continue;
    const bool is_next =
        !holes.loops.empty() && holes.loops.back().cluster == loop.cluster;
    const std::uint64_t tile = is_next ? holes.loops.back().tile
                                       : std::uint64_t{plan.tiling.ownerOf(
                                             holes.edges[std::size_t(loop.begin)][0])};
    holes.loops.push_back(
        {loop.cluster, tile, loop.begin, loop.end, loop.core(), loop.region()});
  }
  writeHoles(plan, holes);
}

std::vector<std::size_t>
holeParts(const TilePlan& plan, std::size_t tile)
{
  const HoleGathering gathering(plan, tile);
  return {gathering.parts().begin(), gathering.parts().end()};
}

void
repairTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, REPAIR_STEP), plan.key))
    return;
  RepairedTile repaired;
  const pcl::repair::RepairParameters method = methodFor(plan);
  HoleGathering gathering(plan, tile);
  for (const HoleCluster& cluster : gathering.gather())
    repairCluster(plan, gathering, cluster, method, run, repaired);
  writeRepaired(plan, tile, repaired);
}

void
numberRepairs(const TilePlan& plan)
{
  if (isDone(plan.file(NUMBERS_FILE), plan.key))
    return;
  RepairNumbers numbers;
  const pcl::ccaa::Tile& last = plan.tiling.tiles.back();
  numbers.first.push_back(last.first + last.count);
  numbers.components = readSides(plan).components;
  pcl::ccaa::DisjointSets sets(numbers.components);
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const RepairedTile repaired = readRepaired(plan, tile);
    numbers.first.push_back(numbers.first.back() + repaired.facts.vertices);
    numbers.facts.add(repaired.facts);
    for (const auto& [one, other] : repaired.joined)
      if (sets.find(one) != sets.find(other)) {
        sets.join(one, other);
        --numbers.components;
      }
  }
  double area = 0.0;
  for (const pcl::ccaa::TilePieces& pieces : readAllSums(plan))
    for (const pcl::ccaa::SideSums& sums : pieces.sums)
      area += sums.area / 2.0;
  const double most = settingsOf(plan).method.greatest_unsupported;
  if (most < 1.0 && numbers.facts.area > most * (area + numbers.facts.area))
    ++numbers.facts.doubts[std::size_t(pcl::DoubtReason::UNSUPPORTED)];
  writeNumbers(plan, numbers);
}

TileSurface
readRepairedSurface(const TilePlan& plan, std::size_t tile)
{
  TileSurface surface = readSurface(plan, tile);
  if (!plan.repairs())
    return surface;
  const RepairNumbers numbers = readNumbers(plan);
  const RepairedTile repaired = readRepaired(plan, tile);
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  const auto numberOf = [&](WideIndex corner) {
    return corner < numbers.first[0] ? corner
                                     : corner - numbers.first[0] + numbers.first[tile];
  };
  std::vector<WideIndex> foreign = surface.foreign;
  for (const WideTriangle& triangle : repaired.triangles)
    for (const WideIndex corner : triangle)
      if (!own.owns(corner))
        foreign.push_back(numberOf(corner));
  pcl::ccaa::sortUnique(foreign);
  const auto placeOf = [&](WideIndex corner) {
    if (own.owns(corner))
      return static_cast<std::uint32_t>(corner - own.first);
    return static_cast<std::uint32_t>(own.count) +
           static_cast<std::uint32_t>(
               std::lower_bound(foreign.begin(), foreign.end(), corner) -
               foreign.begin());
  };
  for (CoreTriangle& triangle : surface.triangles)
    for (std::uint32_t& corner : triangle)
      corner = placeOf(surface.wideOf(own, corner));
  for (const WideTriangle& triangle : repaired.triangles)
    surface.triangles.push_back({placeOf(numberOf(triangle[0])),
                                 placeOf(numberOf(triangle[1])),
                                 placeOf(numberOf(triangle[2]))});
  surface.foreign = std::move(foreign);
  return surface;
}

} // namespace app
