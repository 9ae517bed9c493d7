// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps that repair what the tiles have left open.
#include "cli/repair_run.h"
#include "mesh/box_tree.h"
#include "mesh/disjoint_sets.h"
#include "mesh/intersection.h"
#include "mesh/sort_unique.h"
#include "out_of_core/cluster_repair.h"
#include "out_of_core/hole_gathering.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_points.h"
#include "out_of_core/tile_steps.h"

#include <algorithm>
#include <deque>
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

/** How many points of all tiles lie in a box. */
class PointCounter {
public:
  explicit PointCounter(const TilePlan& plan) : plan_(plan)
  {
    for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
      tiles_.emplace_back(plan, tile);
  }

  std::uint64_t
  count(const pcl::ccaa::Box& box) const
  {
    std::uint64_t points = 0;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
      if (plan_.tiling.tiles[tile].box.intersects(box))
        tiles_[tile].forEachIn(box, [&](std::size_t) { ++points; });
    return points;
  }

private:
  const TilePlan& plan_;
  std::deque<TilePoints> tiles_;
};

std::vector<pcl::ccaa::TilePieces>
readAllSums(const TilePlan& plan)
{
  std::vector<pcl::ccaa::TilePieces> tiles;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
    tiles.push_back(readPiecesSums(plan, tile));
  return tiles;
}

/** Patches of which a triangle meets, or shares a corner with, one of a cluster with a
 * lower number: each by its tile and its number there, ascending. */
std::vector<std::array<std::uint64_t, 2>>
patchesToDrop(const TilePlan& plan)
{
  struct Exposed {
    std::array<std::uint64_t, 2> patch; // tile and number
    std::uint64_t cluster;
    WideTriangle corners;
    pcl::ccaa::Corners positions;
  };
  std::vector<Exposed> exposed;
  std::vector<pcl::ccaa::Box> boxes;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const RepairedTile repaired = readRepaired(plan, tile, false);
    for (const ExposedTriangle& triangle : repaired.exposed) {
      const double* p = triangle.positions.data();
      exposed.push_back({{tile, triangle.patch},
                         repaired.patches[triangle.patch].cluster,
                         triangle.corners,
                         {Position(p), Position(p + 3), Position(p + 6)}});
      boxes.push_back(pcl::ccaa::boxOf(exposed.back().positions));
    }
  }
  const auto meet = [](const Exposed& one, const Exposed& other) {
    const bool shares =
        std::any_of(one.corners.begin(), one.corners.end(), [&](WideIndex corner) {
          return std::find(other.corners.begin(), other.corners.end(), corner) !=
                 other.corners.end();
        });
    return shares || pcl::ccaa::isCollinear(one.positions) ||
           pcl::ccaa::isCollinear(other.positions) ||
           pcl::ccaa::trianglesMeet(one.positions, other.positions);
  };
  const pcl::ccaa::BoxTree tree(boxes);
  std::vector<std::array<std::uint64_t, 2>> dropped;
  for (std::size_t i = 0; i < exposed.size(); ++i)
    if (tree.anyMeeting(boxes[i], [&](pcl::index_t k) {
          const Exposed& other = exposed[static_cast<std::size_t>(k)];
          return other.cluster < exposed[i].cluster && meet(other, exposed[i]);
        }))
      dropped.push_back(exposed[i].patch);
  pcl::ccaa::sortUnique(dropped);
  return dropped;
}

/** The method as the user wants it, with what is known of the whole. What needs the
 * whole is judged for all tiles together. */
pcl::repair::RepairParameters
methodFor(const TilePlan& plan)
{
  const ReconstructSettings settings = settingsOf(plan);
  pcl::repair::RepairParameters method = settings.method;
  method.survey.orientation.sides =
      sidesOf(sidesForRepair(settings.sides, readSides(plan).tally), plan.viewpoint);
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
  const PointCounter counter(plan);
  std::vector<pcl::ccaa::OpenLoop> loops = clusterLoops(
      edges,
      points,
      positions,
      sumUpComponents(tiles, sides),
      plan.tiling,
      [&](const pcl::ccaa::Box& box) { return counter.count(box); },
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
        {loop.cluster, tile, loop.begin, loop.end, loop.region(), loop.points});
  }
  writeHoles(plan, holes);
}

std::vector<std::size_t>
holeParts(const TilePlan& plan, std::size_t tile)
{
  const HoleGathering gathering(plan, tile);
  return {gathering.parts().begin(), gathering.parts().end()};
}

std::vector<std::uint64_t>
repairPoints(const TilePlan& plan)
{
  std::vector<std::uint64_t> points(plan.tiling.tiles.size(), 0);
  for (const HoleLoop& loop : readHoles(plan).loops)
    points[loop.tile] += loop.points;
  return points;
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
  numbers.dropped = patchesToDrop(plan);
  numbers.first.push_back(plan.pointsInTiles());
  numbers.components = readSides(plan).components;
  numbers.facts.dropped = numbers.dropped.size();
  pcl::ccaa::DisjointSets sets(numbers.components);
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const RepairedTile repaired = readRepaired(plan, tile, false);
    const auto isDropped = [&](std::uint64_t patch) {
      return std::binary_search(numbers.dropped.begin(),
                                numbers.dropped.end(),
                                std::array<std::uint64_t, 2>{tile, patch});
    };
    numbers.facts.add(repaired.facts);
    for (std::size_t patch = 0; patch < repaired.patches.size(); ++patch)
      if (!isDropped(patch))
        numbers.sum.add(repaired.patches[patch]);
    numbers.first.push_back(numbers.first.front() + numbers.sum.vertices);
    for (const auto& [patch, one, other] : repaired.joined)
      if (!isDropped(patch) && sets.find(one) != sets.find(other)) {
        sets.join(one, other);
        --numbers.components;
      }
  }
  double area = 0.0;
  for (const pcl::ccaa::TilePieces& pieces : readAllSums(plan))
    for (const pcl::ccaa::SideSums& sums : pieces.sums)
      area += sums.area / 2.0;
  const pcl::repair::RepairParameters method = settingsOf(plan).method;
  const double most = method.greatest_unsupported;
  const bool is_closed =
      std::int64_t(readSides(plan).open_edges) + numbers.sum.open_edges == 0;
  if (is_closed && !method.closesAll() && most < 1.0 &&
      numbers.sum.area > most * (area + numbers.sum.area))
    ++numbers.facts.doubts[std::size_t(pcl::DoubtReason::UNSUPPORTED)].count;
  writeNumbers(plan, numbers);
}

RepairedTile
readStayingPatches(const TilePlan& plan, std::size_t tile)
{
  const RepairNumbers numbers = readNumbers(plan);
  const RepairedTile all = readRepaired(plan, tile, true);
  RepairedTile left;
  const std::uint64_t first_new = plan.pointsInTiles();
  auto triangle = all.triangles.begin();
  std::uint64_t vertices = 0, gone = 0;
  const std::size_t bytes = plan.layout.point_step;
  for (std::size_t k = 0; k < all.patches.size(); ++k) {
    const RepairedPatch& patch = all.patches[k];
    const auto end = triangle + static_cast<std::ptrdiff_t>(patch.triangles);
    const auto record =
        all.records.begin() + static_cast<std::ptrdiff_t>(vertices * bytes);
    vertices += patch.vertices;
    if (std::binary_search(numbers.dropped.begin(),
                           numbers.dropped.end(),
                           std::array<std::uint64_t, 2>{tile, k})) {
      gone += patch.vertices;
      triangle = end;
      continue;
    }
    left.records.insert(left.records.end(),
                        record,
                        record + static_cast<std::ptrdiff_t>(patch.vertices * bytes));
    for (; triangle != end; ++triangle) {
      left.triangles.push_back(*triangle);
      for (WideIndex& corner : left.triangles.back())
        if (corner >= first_new)
          corner += numbers.first[tile] - first_new - gone;
    }
  }
  return left;
}

TileSurface
readRepairedSurface(const TilePlan& plan, std::size_t tile)
{
  TileSurface surface = readSurface(plan, tile);
  if (!plan.repairs())
    return surface;
  const RepairedTile repaired = readStayingPatches(plan, tile);
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  std::vector<WideIndex> foreign = surface.foreign;
  for (const WideTriangle& triangle : repaired.triangles)
    for (const WideIndex corner : triangle)
      if (!own.owns(corner))
        foreign.push_back(corner);
  pcl::ccaa::sortUnique(foreign);
  const auto placeOf = [&](WideIndex corner) { return numberIn(own, foreign, corner); };
  for (CoreTriangle& triangle : surface.triangles)
    for (std::uint32_t& corner : triangle)
      corner = placeOf(surface.wideOf(own, corner));
  for (const WideTriangle& triangle : repaired.triangles)
    surface.triangles.push_back(
        {placeOf(triangle[0]), placeOf(triangle[1]), placeOf(triangle[2])});
  surface.foreign = std::move(foreign);
  return surface;
}

} // namespace app
