// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island is outside (4.48).

#include "orientation/island_orientation.h"

#include "field/reach.h"
#include "mesh/corners.h"
#include "mesh/given_votes.h"
#include "orientation/field_integrals.h"
#include "orientation/free_sight.h"
#include "orientation/side_decision.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** How much more the model lets in sight on one side than on the other, 0 to 1, by
 * area. Ways to a closed body's inner side are blocked; of a range map both sides are
 * seen from everywhere, and then a single island that is seen better from one side
 * means little. */
double
closednessOf(const IncompleteModel& model, const std::vector<FreeSight>& sights)
{
  double decided = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    decided += model.islands[i].area * std::abs(sights[i].votes.balance());
    all += model.islands[i].area;
  }
  return all > 0.0 ? decided / all : 0.0;
}

/** Range maps and terrains have a closedness of 0.07 to 0.15, closed bodies of which a
 * third is missing 0.33 and more. */
double
trustOf(double closedness)
{
  return std::clamp(5.0 * (closedness - 0.1), 0.0, 1.0);
}

/** Votes decide an island that no rule has decided yet. */
void
decide(const ccaa::SideVotes& votes,
       SideRule rule,
       double decided_from,
       IslandSide& side)
{
  if (side.rule == SideRule::UNDECIDED && votes.margin() >= decided_from)
    side = {rule, votes.sum < 0.0, votes.margin()};
}

/** What hints say about each island. */
std::vector<ccaa::GivenSides>
sumOfHints(const IncompleteModel& model, const ccaa::OrientationHints& hints)
{
  std::vector<ccaa::GivenSides> sums(model.islands.size());
  const ccaa::GivenVotes votes(hints);
  for (std::size_t t = 0; votes.any() && t < model.triangles.size(); ++t)
    votes.add(model.triangles[t],
              ccaa::facetOf(ccaa::cornersOf(model.triangles[t], model.positions)),
              sums[model.island_of[t]]);
  return sums;
}

/** What the user tells, then what the cloud has. */
void
decideByWhatIsGiven(const IncompleteModel& model,
                    const OrientationParameters& parameters,
                    std::vector<IslandSide>& sides)
{
  using ccaa::OutwardRule;
  ccaa::OrientationHints hints;
  hints.up = parameters.sides.up;
  hints.normals = model.given_normals;
  hints.viewpoints = model.viewpoints;
  const std::vector<ccaa::GivenSides> sums = sumOfHints(model, hints);
  const auto ask = [&](OutwardRule votes, SideRule rule, double decided_from) {
    for (std::size_t i = 0; i < sides.size(); ++i)
      decide(sums[i][static_cast<std::size_t>(votes)], rule, decided_from, sides[i]);
  };
  const auto askViewpoints = [&](OutwardRule teller, SideRule rule) {
    if (model.viewpoints_by == teller)
      ask(OutwardRule::VIEWPOINT, rule, ccaa::VOTE_MARGIN);
  };
  askViewpoints(OutwardRule::TOLD_VIEWPOINT, SideRule::TOLD_VIEWPOINT);
  if (!parameters.sides.up_is_guessed)
    ask(OutwardRule::UP, SideRule::UP, ccaa::VOTE_MARGIN);
  ask(OutwardRule::NORMALS, SideRule::NORMALS, parameters.agreement);
  askViewpoints(OutwardRule::VIEWPOINT, SideRule::VIEWPOINT);
  askViewpoints(OutwardRule::ORIGIN, SideRule::ORIGIN);
  if (parameters.sides.up_is_guessed)
    ask(OutwardRule::UP, SideRule::PLANE, ccaa::VOTE_MARGIN);
}

/** Share of a surface's area up to which its openings leave no doubt about what is
 * inside. */
constexpr double SMALL_OPENINGS = 0.1;

/** The volume that an island encloses, its openings closed from their centres, by the
 * winding it has: below 0 it is wound inward. */
double
signedVolume(const IncompleteModel& model, const BoundaryLoops& loops)
{
  const Position origin = model.positions.front();
  const auto volume = [&](const Position& a, const Position& b, const Position& c) {
    return (a - origin).dot((b - origin).cross(c - origin)) / 6.0;
  };
  double sum = 0.0;
  for (const Triangle& triangle : model.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, model.positions);
    sum += volume(corners[0], corners[1], corners[2]);
  }
  for (const BoundaryLoop& loop : loops) {
    Position center = Position::Zero();
    for (const Position& point : loop.curve.points)
      center += point / static_cast<double>(loop.curve.size());
    for (std::size_t k = 0; k < loop.curve.size(); ++k)
      sum +=
          volume(loop.curve.points[loop.curve.next(k)], loop.curve.points[k], center);
  }
  return sum;
}

/** An only island that is closed but for small openings is outside where its volume
 * is positive. Sight would say the same, for a tree over all triangles. */
void
decideByVolume(const IncompleteModel& model,
               const BoundaryLoops& loops,
               std::vector<IslandSide>& sides)
{
  if (sides.size() != 1 || sides[0].rule != SideRule::UNDECIDED)
    return;
  double area = 0.0; // each is no larger than a disc (isoperimetric inequality)
  for (const BoundaryLoop& loop : loops)
    area += loop.length * loop.length / (4.0 * M_PI);
  if (area > SMALL_OPENINGS * model.islands[0].area)
    return;
  const double volume = signedVolume(model, loops);
  if (volume != 0.0)
    sides[0] = {SideRule::VOLUME, volume < 0.0, 1.0};
}

/** The rules of 4.48, for the islands that are still undecided. */
void
decideByField(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const OrientationParameters& parameters,
              double room,
              const ccaa::LoopContext& context,
              std::vector<IslandSide>& sides)
{
  const double clearance = parameters.sight_clearance * meanSpacing(model.free_points);
  SideEvidence evidence;
  evidence.sight = lookAround(model, clearance, context);
  evidence.sight_trust = trustOf(closednessOf(model, evidence.sight));
  for (std::size_t i = 0; evidence.sight_trust > 0.0 && i < sides.size(); ++i)
    if (evidence.sight[i].share() >= parameters.least_sight)
      decide(evidence.sight[i].votes,
             SideRule::FREE_SIGHT,
             parameters.clear_sight / evidence.sight_trust,
             sides[i]);
  for (const Island& island : model.islands)
    evidence.areas.push_back(island.area);
  evidence.pairs = pairIntegrals(loops, room, context);
  decideByField(evidence, parameters, sides);
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
  case SideRule::VOLUME:
    return "enclosed volume";
  case SideRule::FREE_SIGHT:
    return "free sight";
  case SideRule::FIELD:
    return "field";
  case SideRule::UNDECIDED:
    return "undecided";
  case SideRule::ONE_SIDED:
    return "one-sided";
  case SideRule::TOLD_VIEWPOINT:
    return "the viewpoint told";
  case SideRule::UP:
    return "the up direction told";
  case SideRule::ORIGIN:
    return "the origin taken as sensor position";
  case SideRule::PLANE:
    return "guessed: up from the dominant plane";
  }
  return "unknown";
}

std::vector<IslandSide>
orientIslands(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const OrientationParameters& parameters,
              double room,
              const ccaa::LoopContext& context)
{
  std::vector<IslandSide> sides(model.islands.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (model.islands[i].one_sided)
      sides[i].rule = SideRule::ONE_SIDED;
  decideByWhatIsGiven(model, parameters, sides);
  decideByVolume(model, loops, sides);
  const bool any_open =
      std::any_of(sides.begin(), sides.end(), [](const IslandSide& s) {
        return s.rule == SideRule::UNDECIDED;
      });
  if (any_open)
    decideByField(model, loops, parameters, room, context, sides);
  return sides;
}

void
turnIslands(IncompleteModel& model, const std::vector<IslandSide>& sides)
{
  std::vector<bool> of_turned(model.positions.size(), false);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    if (!sides[model.island_of[t]].flipped)
      continue;
    model.adjacency.turn(static_cast<pcl::index_t>(t), model.triangles);
    for (const pcl::index_t vertex : model.triangles[t])
      of_turned[static_cast<std::size_t>(vertex)] = true;
  }
  for (std::size_t v = 0; v < model.normals.size(); ++v)
    if (of_turned[v])
      model.normals[v] = -model.normals[v];
}

} // namespace pcl::repair
