// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is told about a run tile by tile.
#include "cli/doubt_words.h"
#include "out_of_core/repair_files.h"
#include "out_of_core/shards.h"
#include <nlohmann/json.hpp>

#include <filesystem>

namespace app {

namespace fs = std::filesystem;

namespace {

/** The reasons of which there are any, with their numbers. */
template <typename Reason, typename Counts>
nlohmann::json
countsOf(const Counts& counts)
{
  nlohmann::json found = nlohmann::json::object();
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0)
      found[nameOf(Reason(i))] = counts[i];
  return found;
}

/** By reason, and where one of each is, if that has a place. */
void
addDoubts(const TileRepairFacts& made, nlohmann::json& repair)
{
  repair["doubts"] = repair["doubts_at"] = nlohmann::json::object();
  for (std::size_t i = 0; i < made.doubts.size(); ++i) {
    const std::string reason = nameOf(pcl::DoubtReason(i));
    if (made.doubts[i].count > 0)
      repair["doubts"][reason] = made.doubts[i].count;
    if (made.doubts[i].has_place)
      repair["doubts_at"][reason] = made.doubts[i].place;
  }
}

/** What became of the holes, and what that changes about the whole. */
void
addRepair(const TilePlan& plan, nlohmann::json& facts)
{
  const AllHoles holes = readHoles(plan);
  const RepairNumbers numbers = readNumbers(plan);
  const TileRepairFacts& made = numbers.facts;
  facts["vertices"] = std::uint64_t{facts["vertices"]} + numbers.sum.vertices;
  facts["components"] = numbers.components;
  facts["open_edges"] = std::int64_t{facts["open_edges"]} + numbers.sum.open_edges;
  nlohmann::json shortfalls = countsOf<pcl::OpenReason>(made.shortfalls);
  if (made.against > 0)
    shortfalls["AGAINST_EACH_OTHER"] = made.against;
  if (made.dropped > 0)
    shortfalls["MEETS_ANOTHER_PATCH"] = made.dropped;
  if (made.astray > 0)
    shortfalls["OUT_OF_ITS_REGION"] = made.astray;
  if (holes.beyond > 0)
    shortfalls["BEYOND_A_TILE"] = holes.beyond;
  const std::uint64_t left_out = made.dropped + made.astray + made.against;
  facts["repair"] = {{"boundaries", holes.loops.size() + holes.borders + holes.beyond},
                     {"outer_borders_beyond_a_tile", holes.borders},
                     {"closed", made.closed - std::min(made.closed, left_out)},
                     {"new_triangles", numbers.sum.triangles},
                     {"new_vertices", numbers.sum.vertices},
                     {"shortfalls", shortfalls},
                     {"kept", countsOf<pcl::OpenReason>(made.kept)}};
  addDoubts(made, facts["repair"]);
}

} // namespace

nlohmann::json
describeTiles(const TilePlan& plan)
{
  const pcl::ccaa::Sides sides = readSides(plan);
  std::uint64_t triangles = 0, added = 0, failed = 0;
  nlohmann::json shards = nlohmann::json::array();
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
    const std::size_t count = countTriangles(plan, tile);
    const ClosedTile closed = readClosed(plan, tile);
    triangles += count;
    added += closed.added.size();
    failed += closed.failed;
    shards.push_back({{"first_vertex", own.first},
                      {"vertices", own.count},
                      {"triangles", count},
                      {"min", {own.box.min()[0], own.box.min()[1], own.box.min()[2]}},
                      {"max", {own.box.max()[0], own.box.max()[1], own.box.max()[2]}}});
    if (const fs::path path = plan.file(tile, SHARD_STEP); fs::exists(path))
      shards.back()["file"] = path.filename();
  }
  const AllDisputes disputes = readDisputes(plan);
  const std::uint64_t unused = mostlyUnused(sides.doubts.places, sides.doubts.used);
  nlohmann::json facts = {{"key", plan.key},
                          {"vertices", plan.points() - plan.nowhere},
                          {"points_without_position", plan.nowhere},
                          {"triangles", triangles},
                          {"components", sides.components},
                          {"open_edges", sides.open_edges},
                          {"torn_edges", sides.torn.size()},
                          {"doubtful_handles", sides.doubts.handles.count},
                          {"touching_pieces", sides.doubts.touching_pieces.count},
                          {"thin_necks", sides.doubts.thin_necks.count},
                          {"unused_points", unused},
                          {"seams",
                           {{"disputed_points", disputes.disputes.size()},
                            {"places", disputes.groups.size()},
                            {"triangles", added},
                            {"places_not_closed", failed}}},
                          {"outer_side", describe(sides.tally)},
                          {"shards", shards}};
  const auto addPlace = [&](const char* name, const pcl::ccaa::PlacedCount& count) {
    if (count.has_place)
      facts[name] = count.place;
  };
  addPlace("doubtful_handles_at", sides.doubts.handles);
  addPlace("touching_pieces_at", sides.doubts.touching_pieces);
  addPlace("thin_necks_at", sides.doubts.thin_necks);
  if (plan.repairs())
    addRepair(plan, facts);
  return facts;
}

void
writeIndex(const TilePlan& plan)
{
  OutputFile file;
  require(file.open(plan.file(INDEX_FILE)));
  file.text(describeTiles(plan).dump(1) + "\n");
  require(file.commit());
}

} // namespace app
