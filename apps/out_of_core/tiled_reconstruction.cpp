// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_ccaa_reconstruct --tiles.
#include "out_of_core/tiled_reconstruction.h"

#include "cli/doubt_words.h"
#include "cli/progress.h"
#include "cli/run_facts.h"
#include "io/interrupt.h"
#include "io/output_folder.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "out_of_core/partition.h"
#include "out_of_core/shards.h"
#include "out_of_core/tile_run.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <ostream>

namespace app {
namespace {

/** Shares of the time for cutting, and for everything before merging. */
constexpr double CUTTING = 0.1;
constexpr double BEFORE_MERGING = 0.95;

/** Removes the folder of a run that is to leave none. */
class TileFolder {
public:
  explicit TileFolder(const ReconstructSettings& settings)
  : path(settings.tile_folder.empty() ? settings.files.output + ".tiles"
                                      : settings.tile_folder)
  , stays(!settings.tile_folder.empty())
  {
    if (!stays && std::filesystem::exists(path))
      throw Failure(
          "the folder '" + path +
          "' is in the way; remove it, or name it with --tile-folder to go on "
          "with what is in it");
  }
  ~TileFolder()
  {
    std::error_code error;
    if (!stays)
      std::filesystem::remove_all(path, error);
  }
  TileFolder(const TileFolder&) = delete;
  TileFolder&
  operator=(const TileFolder&) = delete;

  const std::string path;
  const bool stays;
};

std::string
summarize(const nlohmann::json& facts, std::size_t tiles, const std::string& where)
{
  const nlohmann::json& seams = facts["seams"];
  const std::string side = facts["outer_side"];
  return where + ": " + plural(std::uint64_t{facts["vertices"]}, "point") + " in " +
         plural(tiles, "tile") + ", " +
         std::to_string(std::uint64_t{facts["triangles"]}) + " triangles, " +
         plural(std::uint64_t{facts["open_edges"]}, "open edge") +
         "; tiles disagreed at " + plural(std::uint64_t{seams["places"]}, "place") +
         ", " + plural(std::uint64_t{seams["triangles"]}, "triangle") + " made there" +
         (facts.contains("repair")
              ? "; " + plural(std::uint64_t{facts["repair"]["closed"]}, "hole") +
                    " closed"
              : "") +
         (side.empty() ? "" : "; outer side by " + side);
}

/** The entries of an object of counts, such as "2 INTERSECTION, 1 TOO_LARGE". */
std::string
tellCounts(const nlohmann::json& counts)
{
  std::string text;
  for (const auto& [name, count] : counts.items())
    addToList(text, std::to_string(std::uint64_t{count}) + " " + name);
  return text;
}

std::string
tellPlace(const nlohmann::json& place)
{
  return "at " + placeText({double{place[0]}, double{place[1]}, double{place[2]}}, " ");
}

DoubtCounts
doubtCounts(const nlohmann::json& facts)
{
  const auto at = [&](const char* place) {
    return facts.contains(place) ? tellPlace(facts[place]) : "";
  };
  return {facts["doubtful_handles"],
          facts["touching_pieces"],
          facts["thin_necks"],
          at("doubtful_handles_at"),
          at("touching_pieces_at"),
          at("thin_necks_at")};
}

/** What leaves the topology in doubt. */
std::string
nameDoubts(const nlohmann::json& facts)
{
  std::string doubts =
      facts.contains("repair") ? tellCounts(facts["repair"]["doubts"]) : "";
  if (const std::uint64_t unused = facts["unused_points"]; unused > 0)
    addToList(doubts, std::to_string(unused) + " UNUSED_POINTS");
  listDoubts(doubtCounts(facts), doubts);
  return doubts;
}

std::string
tellPieces(const nlohmann::json& facts)
{
  const std::uint64_t open = facts["open_edges"];
  if (std::uint64_t{facts["triangles"]} == 0)
    return "no triangles";
  const std::string doubts = nameDoubts(facts);
  return (open == 0 ? "watertight" : plural(open, "open edge")) + ", " +
         plural(std::uint64_t{facts["components"]}, "piece") +
         (doubts.empty() ? "" : ", in doubt (" + doubts + ")");
}

/** What a repair has left open or in doubt; empty: nothing. */
std::string
tellRepair(const nlohmann::json& repair)
{
  if (!repair["shortfalls"].empty())
    return "left open: " + tellCounts(repair["shortfalls"]);
  if (repair["doubts"].empty())
    return "";
  std::string text = "in doubt: " + tellCounts(repair["doubts"]);
  for (const auto& [name, place] : repair["doubts_at"].items())
    text += "; one " + name + " is " + tellPlace(place);
  return text;
}

Outcome
judge(const nlohmann::json& facts, const TilePlan& plan)
{
  Outcome outcome;
  outcome.notes = plan.warnings;
  if (plan.nowhere > 0)
    outcome.notes.push_back(pluralHas(plan.nowhere, "point") +
                            " no position that is finite, and no triangle");
  const std::uint64_t failed = facts["seams"]["places_not_closed"];
  if (std::uint64_t{facts["triangles"]} == 0)
    outcome.reason = "no triangle could be made that is sure to be right";
  else if (failed > 0)
    outcome.reason =
        plural(failed, "place") + " where tiles disagreed could not be closed";
  else if (std::uint64_t{facts["torn_edges"]} > 0)
    outcome.reason = "the surface is one-sided and was opened at " +
                     plural(std::uint64_t{facts["torn_edges"]}, "edge");
  else if (const std::uint64_t unused = facts["unused_points"]; unused > 0)
    outcome.reason = tellUnused(unused);
  else if (facts.contains("repair"))
    outcome.reason = tellRepair(facts["repair"]);
  if (outcome.reason.empty())
    outcome.reason = tellDoubts(doubtCounts(facts), "at most ");
  outcome.code = outcome.reason.empty() ? DONE : INCOMPLETE;
  return outcome;
}

} // namespace

Outcome
reconstructInTiles(const ReconstructSettings& settings)
{
  ProgressBar bar(settings.quiet);
  const TileFolder folder(settings);
  const TilePlan plan =
      partition(settings.files.inputs,
                folder.path,
                settings.tiles,
                settingsText(settings),
                settings.threads,
                [&](double share) { return bar.show("cutting", CUTTING * share); });
  if (interrupted())
    return {INTERRUPTED, stopped_by_signal, {}};
  if (const std::uint64_t points = plan.points() - plan.nowhere; points < 3)
    throw Failure("of at least three points needed (finite) there " +
                  std::string(points == 1 ? "is " : "are ") + std::to_string(points));
  const auto tell = [&](const char* step, double share) {
    return bar.show(step, CUTTING + (BEFORE_MERGING - CUTTING) * share);
  };
  try {
    runTiles(plan, settings.memory, settings.threads, folder.stays, tell);
  }
  catch (const Failure&) {
    if (interrupted())
      return {INTERRUPTED, stopped_by_signal, {}};
    throw;
  }
  nlohmann::json facts = describeTiles(plan);
  Outcome outcome = judge(facts, plan);
  OutputFolder outputs;
  if (!settings.files.output.empty() && bar.show("merging", BEFORE_MERGING))
    mergeTiles(plan,
               facts["triangles"],
               folder.stays,
               outputs.addElsewhere(settings.files.output));
  if (!settings.files.report.empty())
    writeReport(facts, outputs.addElsewhere(settings.files.report));
  if (interrupted())
    return {INTERRUPTED, stopped_by_signal, {}};
  require(outputs.commit());
  bar.clear();
  std::ostream& people = peopleStream({settings.files.output, settings.files.report});
  const std::string where =
      settings.files.output.empty() ? folder.path : settings.files.output;
  if (!settings.quiet)
    people << summarize(facts, plan.tiling.tiles.size(), where) << std::endl;
  outcome.verdict = {tellPieces(facts), &people};
  return outcome;
}

} // namespace app
