// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair would do, told without doing it.
#include "dry_run.h"

#include "io/wording.h"
#include "repair/decision_proposal.h"
#include "repair_details.h"
#include <nlohmann/json.hpp>

#include <algorithm>

namespace app {
namespace {

using pcl::OpenReason;
using pcl::repair::BoundaryClass;
using pcl::repair::LoopDecision;
using pcl::repair::ModelSurvey;

/** Lines for single holes, before it is too much to read. */
constexpr std::size_t most_holes_told = 10;

bool
isHole(const LoopDecision& loop)
{
  return loop.joined ? loop.found == BoundaryClass::HOLE
                     : loop.reason == OpenReason::NONE;
}

/** Where a loop stands in the plan; not at all if it is to stay as it is. */
void
count(const LoopDecision& loop, RepairPlan& plan)
{
  if (isHole(loop))
    ++plan.holes;
  else if (loop.joined || loop.reason == OpenReason::NOT_JOINED)
    ++plan.rims;
  else if (isShortfall(loop.reason))
    ++plan.undecided;
}

/** Loops that are holes, the longest first. */
std::vector<std::size_t>
holesByLength(const ModelSurvey& survey, const pcl::repair::RepairParameters& method)
{
  std::vector<std::size_t> holes;
  const auto loops = proposeDecisions(survey, method).loops;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (isHole(loops[i]))
      holes.push_back(i);
  std::stable_sort(holes.begin(), holes.end(), [&](std::size_t a, std::size_t b) {
    return survey.loops[a].length > survey.loops[b].length;
  });
  return holes;
}

std::string
tellHole(const pcl::repair::BoundaryLoop& loop)
{
  const auto place = loop.curve.points.front();
  return formatted("  hole of %zu edges, length %g, at %g %g %g\n",
                   loop.curve.size(),
                   loop.length,
                   place.x(),
                   place.y(),
                   place.z());
}

} // namespace

RepairPlan
planRepair(const ModelSurvey& survey, const pcl::repair::RepairParameters& method)
{
  RepairPlan plan;
  for (const LoopDecision& loop : proposeDecisions(survey, method).loops)
    count(loop, plan);
  for (const pcl::repair::IslandSide& side : survey.sides)
    plan.turned_islands += side.flipped ? 1 : 0;
  plan.removed_triangles =
      survey.reading.repeated_triangles + survey.reading.twist_triangles;
  plan.cut_edges = survey.reading.overfull_edges;
  return plan;
}

void
describePlan(const RepairSettings& settings,
             const ModelSurvey& survey,
             nlohmann::json& report)
{
  const RepairPlan plan = planRepair(survey, settings.method);
  const auto& field = settings.method.survey.field;
  report["dry_run"] = true;
  report["would_repair"] = !plan.isEmpty();
  report["plan"] = {{"holes", plan.holes},
                    {"island_rims", plan.rims},
                    {"undecided_loops", plan.undecided},
                    {"turned_islands", plan.turned_islands},
                    {"removed_triangles", plan.removed_triangles},
                    {"cut_edges", plan.cut_edges}};
  nlohmann::json from_data = nlohmann::json::object();
  if (field.near == 0 && survey.spacing > 0)
    from_data["near"] = survey.spacing;
  if (field.far == 0)
    from_data["far_in_gaps"] = field.room;
  report["parameters_from_data"] = std::move(from_data);
}

std::string
summarizePlan(const RepairPlan& plan)
{
  if (plan.isEmpty())
    return "nothing to repair";
  std::string text;
  const auto tell = [&](std::size_t count, const char* word, const char* what) {
    if (count > 0)
      addToList(text, plural(count, word) + what);
  };
  tell(plan.holes, "hole", " to close");
  tell(plan.rims, "island rim", " to join");
  tell(plan.turned_islands, "island", " to turn round");
  tell(plan.removed_triangles, "triangle", " to take out");
  tell(plan.cut_edges, "edge", " of three or more triangles to cut");
  tell(plan.undecided, "undecided boundary loop", "");
  return text;
}

std::string
tellPlan(const RepairSettings& settings, const ModelSurvey& survey)
{
  std::string text;
  const std::vector<std::size_t> holes = holesByLength(survey, settings.method);
  for (std::size_t i = 0; i < std::min(most_holes_told, holes.size()); ++i)
    text += tellHole(survey.loops[holes[i]]);
  if (holes.size() > most_holes_told)
    text += "  and " + plural(holes.size() - most_holes_told, "smaller hole") + "\n";
  const auto& field = settings.method.survey.field;
  if (field.near == 0 && survey.spacing > 0)
    text += formatted("  from the data: L1 %g (mean spacing of boundary points)\n",
                      survey.spacing);
  if (field.far == 0)
    text += formatted("  from the data: L2 %g gaps, at each place\n", field.room);
  return text;
}

} // namespace app
