// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: why a loop that no bridge touches is not to be closed.

#include "listing/loop_reasons.h"

#include "boundary/loop_evidence.h"
#include "junction/depth_jump.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace pcl::repair {

namespace {

/** Why a rim was joined to none: what its junctions say, if they agree. Those of a
 * crumb know too little of the surface to tell another object. */
OpenReason
reasonForRim(const ModelSurvey& survey, std::size_t loop)
{
  const Island& island = survey.model.islands[survey.loops[loop].island];
  if (island.triangles < CRUMB_TRIANGLES)
    return OpenReason::NOT_JOINED;
  std::optional<OpenReason> reason;
  for (const Junction& junction : survey.joined.junctions)
    for (const std::size_t curve : junction.curves) {
      if (survey.joined.loops[curve] != loop)
        continue;
      if (junction.verdict == JunctionVerdict::DIFFERENT_OBJECTS)
        reason = OpenReason::DIFFERENT_OBJECTS;
      else if (junction.verdict != JunctionVerdict::SEEN_EMPTY)
        return OpenReason::NOT_JOINED;
      else if (!reason)
        reason = OpenReason::SEEN_EMPTY;
    }
  return reason.value_or(OpenReason::NOT_JOINED);
}

/** Whether a hole may be the stump of a limb of which another island is a part: capped
 * it would be one for good. */
bool
mayHavePartner(const ModelSurvey& survey, std::size_t number)
{
  if (!mayBeStump(survey.classes[number].evidence))
    return false;
  const double cap = leastSurface(survey.loops[number].curve).upper;
  const std::vector<Island>& islands = survey.model.islands;
  for (std::size_t i = 0; i < islands.size(); ++i)
    if (i != survey.loops[number].island && islands[i].area > cap)
      return true;
  return false;
}

/** The likeliest junction that joins a loop to one of another island; null: none. */
const Junction*
likeliestOf(const ModelSurvey& survey, std::size_t loop)
{
  const Junction* likeliest = nullptr;
  for (const Junction& junction : survey.joined.junctions) {
    const std::size_t first = survey.joined.loops[junction.curves[0]];
    const std::size_t second = survey.joined.loops[junction.curves[1]];
    if (junction.verdict == JunctionVerdict::JOINED &&
        (first == loop || second == loop) &&
        survey.loops[first].island != survey.loops[second].island &&
        (likeliest == nullptr ||
         junction.evidence.logOdds() > likeliest->evidence.logOdds()))
      likeliest = &junction;
  }
  return likeliest;
}

/** Whether two loops of different islands belong to each other rather than to others,
 * but no bridge leads there: one closed by itself would leave two pieces for good. */
bool
hasPartner(const ModelSurvey& survey, std::size_t loop)
{
  const Junction* junction = likeliestOf(survey, loop);
  if (junction == nullptr)
    return false;
  const std::vector<std::size_t>& loops = survey.joined.loops;
  const bool is_first = loops[junction->curves[0]] == loop;
  return likeliestOf(survey, loops[junction->curves[is_first ? 1 : 0]]) == junction;
}

/** Whether a junction joins any loop of an island: a tube that goes on at one end has
 * no second mouth that is open like the other one. */
bool
isJoined(const ModelSurvey& survey, std::size_t island)
{
  const std::vector<Junction>& junctions = survey.joined.junctions;
  return std::any_of(junctions.begin(), junctions.end(), [&](const Junction& junction) {
    const auto isOfIsland = [&](std::size_t curve) {
      return survey.loops[survey.joined.loops[curve]].island == island;
    };
    return junction.verdict == JunctionVerdict::JOINED &&
           (isOfIsland(junction.curves[0]) || isOfIsland(junction.curves[1]));
  });
}

/** What its class says. */
OpenReason
reasonByClass(const ModelSurvey& survey, std::size_t number)
{
  const BoundaryLoop& loop = survey.loops[number];
  const LoopClass& found = survey.classes[number];
  const IncompleteModel& model = survey.model;
  if (model.islands[loop.island].one_sided)
    return OpenReason::ONE_SIDED;
  if (model.islands[loop.island].is_fin)
    return OpenReason::FIN;
  switch (found.boundary_class) {
  case BoundaryClass::HOLE:
    if (hasPartner(survey, number) || mayHavePartner(survey, number))
      return OpenReason::NOT_JOINED;
    return isDepthJump(fillAreaOf(loop.curve), loop.curve, loop.vertices, model)
               ? OpenReason::DEPTH_JUMP
               : OpenReason::NONE;
  case BoundaryClass::ISLAND_RIM:
    return reasonForRim(survey, number);
  case BoundaryClass::OUTER_BORDER:
    return OpenReason::OUTER_BORDER;
  case BoundaryClass::UNDECIDED:
    break;
  }
  if (isOutline(loop.curve, loop.vertices, model))
    return OpenReason::OUTER_BORDER;
  // What joining has left of a gap is no border or mouth that somebody made.
  const bool is_of_input = survey.wishes.inputLoop(model, loop) != NONE;
  if (!is_of_input && isSeenFromAllSides(survey.facing))
    return model.islands.size() == 1 ? OpenReason::NONE : OpenReason::UNDECIDED;
  return found.evidence.is_tube_mouth && !isJoined(survey, loop.island)
             ? OpenReason::TUBE_MOUTH
             : OpenReason::UNDECIDED;
}

/** A loop stays as it is because the user wants it so. */
OpenReason
leftOpen(OpenReason by_class)
{
  return by_class == OpenReason::NONE || isShortfall(by_class) ? OpenReason::NOT_WANTED
                                                               : by_class;
}

/** What its class says where the user says nothing about it. \param[in] is_of_input
 * it has been there from the beginning */
OpenReason
reasonByChoice(const ModelSurvey& survey,
               CloseChoice choice,
               std::size_t loop,
               OpenReason by_class,
               bool is_of_input)
{
  if (by_class == OpenReason::ONE_SIDED || by_class == OpenReason::FIN)
    return by_class;
  if (choice == CloseChoice::ALL)
    return OpenReason::NONE;
  const std::vector<std::size_t>& refused = survey.joined.refused;
  if (couldBeJoined(by_class) &&
      std::binary_search(refused.begin(), refused.end(), loop))
    return OpenReason::NOT_WANTED;
  if (by_class == OpenReason::NOT_JOINED)
    return by_class;
  const bool is_left = is_of_input || by_class == OpenReason::UNDECIDED;
  return choice == CloseChoice::NOTHING && is_left ? leftOpen(by_class) : by_class;
}

} // namespace

OpenReason
reasonForLoop(const ModelSurvey& survey, CloseChoice choice, std::size_t loop)
{
  const std::size_t input_loop =
      survey.wishes.inputLoop(survey.model, survey.loops[loop]);
  const OpenReason by_class = reasonByClass(survey, loop);
  switch (survey.wishes.wishFor(input_loop)) {
  case LoopWish::CLOSE:
    return by_class == OpenReason::ONE_SIDED ? by_class : OpenReason::NONE;
  case LoopWish::LEAVE_OPEN:
    return leftOpen(by_class);
  case LoopWish::AUTO:
    break;
  }
  return reasonByChoice(survey, choice, loop, by_class, input_loop != NONE);
}

} // namespace pcl::repair
