// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island is outside (4.48).

#include <pcl/surface_repair/field/reach.h>
#include <pcl/surface_repair/orientation/island_orientation.h>

#include "field_integrals.h"
#include "free_sight.h"
#include "given_sides.h"
#include "side_decision.h"

#include <cmath>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** Votes decide an island that no rule has decided yet. */
void
decide(const std::vector<SideVotes>& votes,
       SideRule rule,
       double decided_from,
       std::vector<IslandSide>& sides)
{
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double balance = votes[i].balance();
    if (sides[i].rule == SideRule::UNDECIDED && std::abs(balance) >= decided_from)
      sides[i] = {rule, balance < 0.0, std::abs(balance)};
  }
}

} // namespace

const char*
describe(SideRule rule)
{
  switch (rule) {
  case SideRule::NORMALS:
    return "given normals";
  case SideRule::VIEWPOINT:
    return "sensor position";
  case SideRule::FREE_SIGHT:
    return "free sight";
  case SideRule::FIELD:
    return "field";
  case SideRule::UNDECIDED:
    return "undecided";
  case SideRule::ONE_SIDED:
    return "one-sided";
  }
  return "unknown";
}

std::vector<IslandSide>
orientIslands(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const OrientationParameters& parameters,
              const ccaa::LoopContext& context)
{
  std::vector<IslandSide> sides(model.islands.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (model.islands[i].one_sided)
      sides[i].rule = SideRule::ONE_SIDED;
  decide(votesOfNormals(model), SideRule::NORMALS, parameters.agreement, sides);
  decide(votesOfViewpoints(model), SideRule::VIEWPOINT, parameters.agreement, sides);

  const double clearance = parameters.sight_clearance * meanSpacing(model.free_points);
  SideEvidence evidence;
  evidence.sight = lookAround(model, clearance, context);
  std::vector<SideVotes> clear_sight;
  for (const FreeSight& sight : evidence.sight)
    clear_sight.push_back(sight.share() >= parameters.least_sight ? sight.votes
                                                                  : SideVotes{});
  decide(clear_sight, SideRule::FREE_SIGHT, parameters.clear_sight, sides);
  for (const Island& island : model.islands)
    evidence.areas.push_back(island.area);
  evidence.pairs = pairIntegrals(loops, parameters.room, context);
  decideByField(evidence, parameters, sides);
  return sides;
}

void
turnIslands(IncompleteModel& model, const std::vector<IslandSide>& sides)
{
  bool turned = false;
  std::vector<bool> of_turned(model.positions.size(), false);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    if (!sides[model.island_of[t]].flipped)
      continue;
    turned = true;
    std::swap(model.triangles[t][1], model.triangles[t][2]);
    for (const pcl::index_t vertex : model.triangles[t])
      of_turned[static_cast<std::size_t>(vertex)] = true;
  }
  if (!turned)
    return;
  for (std::size_t v = 0; v < model.normals.size(); ++v)
    if (of_turned[v])
      model.normals[v] = -model.normals[v];
  model.adjacency.build(model.triangles, model.positions.size());
}

} // namespace repair
} // namespace pcl
