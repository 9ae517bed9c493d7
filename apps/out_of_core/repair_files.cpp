// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the steps of a repair tile by tile write.
#include "out_of_core/repair_files.h"

#include "out_of_core/step_file.h"

#include <algorithm>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

struct StoredLoop {
  std::uint64_t cluster, tile, begin, end;
  std::array<double, 6> region;
};

} // namespace

void
writeHoles(const TilePlan& plan, const AllHoles& holes)
{
  std::vector<StoredLoop> loops;
  for (const HoleLoop& loop : holes.loops)
    loops.push_back(
        {loop.cluster, loop.tile, loop.begin, loop.end, storedBox(loop.region)});
  StepWriter file(plan.file(HOLES_FILE), plan.key);
  file.putAll(loops);
  file.putAll(holes.edges);
  file.put(holes.borders);
  file.put(holes.beyond);
  file.commit();
}

AllHoles
readHoles(const TilePlan& plan)
{
  StepReader file(plan.file(HOLES_FILE), plan.key);
  AllHoles holes;
  for (const StoredLoop& loop : file.getAll<StoredLoop>())
    holes.loops.push_back(
        {loop.cluster, loop.tile, loop.begin, loop.end, boxOf(loop.region)});
  holes.edges = file.getAll<std::array<WideIndex, 2>>();
  holes.borders = file.get<std::uint64_t>();
  holes.beyond = file.get<std::uint64_t>();
  return holes;
}

void
TileRepairFacts::add(const TileRepairFacts& other)
{
  closed += other.closed;
  for (std::size_t i = 0; i < shortfalls.size(); ++i) {
    shortfalls[i] += other.shortfalls[i];
    kept[i] += other.kept[i];
  }
  for (std::size_t i = 0; i < doubts.size(); ++i)
    doubts[i].add(other.doubts[i]);
  against += other.against;
  astray += other.astray;
  dropped += other.dropped;
}

void
TileRepairFacts::addDoubts(const std::vector<pcl::RepairDoubt>& more,
                           const pcl::ccaa::PointView& points)
{
  for (const pcl::RepairDoubt& doubt : more)
    doubts[static_cast<std::size_t>(doubt.reason)].add(pcl::ccaa::PlacedCount::at(
        1, points, std::max(doubt.points[0], doubt.points[1])));
}

void
RepairedPatch::add(const RepairedPatch& other)
{
  triangles += other.triangles;
  vertices += other.vertices;
  open_edges += other.open_edges;
  area += other.area;
}

void
writeRepaired(const TilePlan& plan, std::size_t tile, const RepairedTile& repaired)
{
  StepWriter file(plan.file(tile, REPAIR_STEP), plan.key);
  file.put(repaired.facts);
  file.putAll(repaired.patches);
  file.putAll(repaired.joined);
  file.putAll(repaired.exposed);
  file.putAll(repaired.records);
  file.putAll(repaired.triangles);
  file.commit();
}

RepairedTile
readRepaired(const TilePlan& plan, std::size_t tile, bool with_surface)
{
  StepReader file(plan.file(tile, REPAIR_STEP), plan.key);
  RepairedTile repaired;
  repaired.facts = file.get<TileRepairFacts>();
  repaired.patches = file.getAll<RepairedPatch>();
  repaired.joined = file.getAll<std::array<std::uint64_t, 3>>();
  repaired.exposed = file.getAll<ExposedTriangle>();
  if (!with_surface)
    return repaired;
  repaired.records = file.getAll<char>();
  repaired.triangles = file.getAll<WideTriangle>();
  return repaired;
}

void
writeNumbers(const TilePlan& plan, const RepairNumbers& numbers)
{
  StepWriter file(plan.file(NUMBERS_FILE), plan.key);
  file.putAll(numbers.first);
  file.putAll(numbers.dropped);
  file.put(numbers.components);
  file.put(numbers.sum);
  file.put(numbers.facts);
  file.commit();
}

RepairNumbers
readNumbers(const TilePlan& plan)
{
  StepReader file(plan.file(NUMBERS_FILE), plan.key);
  RepairNumbers numbers;
  numbers.first = file.getAll<std::uint64_t>();
  numbers.dropped = file.getAll<std::array<std::uint64_t, 2>>();
  numbers.components = file.get<std::uint64_t>();
  numbers.sum = file.get<RepairedPatch>();
  numbers.facts = file.get<TileRepairFacts>();
  return numbers;
}

} // namespace app
