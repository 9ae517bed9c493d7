// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair would decide, for a user to change.

#include "repair/decision_proposal.h"

#include "listing/hole_list.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::repair {

namespace {

LoopWish
wishAfter(OpenReason reason)
{
  switch (reason) {
  case OpenReason::NONE:
    return LoopWish::CLOSE;
  case OpenReason::OUTER_BORDER:
  case OpenReason::TUBE_MOUTH:
  case OpenReason::DEPTH_JUMP:
  case OpenReason::TOO_LARGE:
  case OpenReason::NOT_WANTED:
    return LoopWish::LEAVE_OPEN;
  default:
    return LoopWish::AUTO;
  }
}

double
lengthOf(const Bridge& bridge)
{
  double length = 0.0;
  for (std::size_t k = 1; k < bridge.points.size(); ++k)
    length += (bridge.points[k] - bridge.points[k - 1]).norm();
  return length;
}

std::vector<LoopDecision>
proposeLoops(const ModelSurvey& survey, const FillingParameters& parameters)
{
  std::vector<LoopDecision> loops;
  for (std::size_t k = 0; k < survey.loops.size(); ++k) {
    LoopDecision loop;
    loop.key = keyOf(survey.model, survey.loops[k]);
    loop.island = survey.loops[k].island;
    loop.length = survey.loops[k].length;
    loop.found = survey.classes[k].boundary_class;
    loop.confidence = survey.classes[k].confidence;
    loop.joined = true; // unless it is listed by itself
    loop.wish = survey.wishes.wishFor(k);
    loop.cap = survey.wishes.capFor(k);
    loops.push_back(loop);
  }
  for (const OpenHole& hole : listHoles(survey, parameters).holes)
    if (hole.loop != NONE && hole.other_loop == NONE) {
      LoopDecision& loop = loops[hole.loop];
      loop.joined = false;
      loop.reason = hole.open;
      loop.wish = wishAfter(hole.open);
    }
  return loops;
}

using Pair = std::pair<std::size_t, std::size_t>;

/** What evidence says about each junction, and what the user has said. */
std::map<Pair, JunctionDecision>
judgedJunctions(const ModelSurvey& survey)
{
  const SurveyedBridges& joined = survey.joined;
  std::map<Pair, JunctionDecision> junctions;
  for (const Junction& found : joined.junctions) {
    const Pair loops =
        std::minmax(joined.loops[found.curves[0]], joined.loops[found.curves[1]]);
    JunctionDecision& junction = junctions[loops];
    junction.first_loop = loops.first;
    junction.second_loop = loops.second;
    junction.verdict = found.verdict;
    junction.confidence = found.confidence;
    const bool must_be = survey.wishes.mustJoin(
        survey.model, survey.loops[loops.first], survey.loops[loops.second]);
    junction.join = must_be || (found.verdict == JunctionVerdict::JOINED &&
                                survey.wishes.apart().count(loops) == 0);
  }
  return junctions;
}

std::vector<JunctionDecision>
proposeJunctions(const ModelSurvey& survey)
{
  const SurveyedBridges& joined = survey.joined;
  std::map<Pair, JunctionDecision> junctions = judgedJunctions(survey);
  for (const Bridge& bridge : joined.bridges) {
    const Pair loops =
        std::minmax(joined.loops[bridge.begin.curve], joined.loops[bridge.end.curve]);
    const auto [place, is_new] = junctions.try_emplace(loops);
    JunctionDecision& junction = place->second;
    if (is_new) { // they have a point in common: nothing is to be judged
      junction.first_loop = loops.first;
      junction.second_loop = loops.second;
      junction.confidence = 1.0;
    }
    const double length = lengthOf(bridge);
    junction.shortest =
        junction.bridges == 0 ? length : std::min(junction.shortest, length);
    junction.quality = std::max(junction.quality, bridge.quality);
    ++junction.bridges;
  }
  std::vector<JunctionDecision> list;
  for (const auto& [loops, junction] : junctions)
    list.push_back(junction);
  return list;
}

} // namespace

Decisions
proposeDecisions(const ModelSurvey& survey, const RepairParameters& parameters)
{
  Decisions decisions;
  decisions.mesh = survey.mesh;
  decisions.loops = proposeLoops(survey, parameters.filling);
  if (parameters.join_islands)
    decisions.junctions = proposeJunctions(survey);
  // Whoever wants a junction joined need not say so of its loops as well.
  for (const JunctionDecision& junction : decisions.junctions)
    for (const std::size_t end : {junction.first_loop, junction.second_loop})
      if (survey.wishes.wishFor(end) == LoopWish::AUTO &&
          decisions.loops[end].wish == LoopWish::LEAVE_OPEN)
        decisions.loops[end].wish = LoopWish::AUTO;
  return decisions;
}

} // namespace pcl::repair
