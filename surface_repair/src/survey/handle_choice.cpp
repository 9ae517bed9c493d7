// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: handles that bridges make, counted before anything is
// filled.

#include "survey/handle_choice.h"

#include "mesh/disjoint_sets.h"
#include "survey/wanted_lines.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** Turn and fold together, in radians, and log odds: a junction that is more bent and
 * less likely may not make a handle. At true cuts through skull, rocker arm and
 * daratech the bend is up to 92 degrees, at false ones 150 and more with odds of up
 * to 3.5; a coarse torus has 120 with odds of 3.9. */
constexpr double MOST_BENT = 2.1;
constexpr double CARRYING_ODDS = 3.6;
/** Bridges, and junctions, that are tried for each handle. */
constexpr std::size_t MOST_TRIES = 64;
/** Times in all that contours are extracted anew. */
constexpr std::size_t MOST_EXTRACTIONS = 1024;

using CurvePair = std::array<std::size_t, 2>;

CurvePair
curvesOf(const Bridge& bridge)
{
  const auto [low, high] = std::minmax(bridge.begin.curve, bridge.end.curve);
  return {low, high};
}

double
bendOf(const Junction& junction)
{
  return junction.evidence.turn + junction.evidence.fold;
}

/** Bridges and contours without some bridges. */
template <typename Dropped>
SurveyedBridges
without(const Dropped& is_dropped,
        const BoundaryEdges& boundaries,
        const SurveyedBridges& joined)
{
  SurveyedBridges left;
  left.loops = joined.loops;
  for (std::size_t b = 0; b < joined.bridges.size(); ++b)
    if (!is_dropped(b))
      left.bridges.push_back(joined.bridges[b]);
  left.holes = extractContours(boundaries, left.bridges);
  return left;
}

/** What may be given up: a single bridge, or all of a junction. */
struct Candidate {
  const Junction* junction = nullptr;
  std::size_t bridge = NONE; /**< NONE: all of them */
};

/** The contours on both sides of each bridge, NONE for one that none passes. */
class BridgeSides {
public:
  explicit BridgeSides(const SurveyedBridges& joined)
  : contours_(joined.holes.contours.size()), sides_(joined.bridges.size(), {NONE, NONE})
  {
    for (std::size_t c = 0; c < contours_; ++c)
      for (const ContourStep& step : joined.holes.contours[c].steps)
        if (step.bridge != NONE)
          sides_[step.bridge][step.backward ? 1 : 0] = c;
  }

  /** \brief Whether fewer handles are possible without some bridges. Each that goes
   * makes one contour of two, which leaves their number as it is, unless one that stays
   * has the same contour on both sides then and goes, too. */
  template <typename Dropped>
  bool
  mayTakeHandle(const Dropped& is_dropped) const
  {
    ccaa::DisjointSets sets(contours_);
    const auto is_same = [&](std::size_t b) {
      return sets.find(sides_[b][0]) == sets.find(sides_[b][1]);
    };
    std::vector<std::size_t> staying;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (sides_[b][0] == NONE)
        continue;
      if (!is_dropped(b)) {
        staying.push_back(b);
        continue;
      }
      if (is_same(b))
        return true;
      sets.join(sides_[b][0], sides_[b][1]);
    }
    return std::any_of(staying.begin(), staying.end(), is_same);
  }

private:
  std::size_t contours_;
  std::vector<std::array<std::size_t, 2>> sides_;
};

/** Of junctions that may not make a handle: single bridges first, so that most of them
 * can stay, then whole junctions. The most bent ones first. */
std::vector<Candidate>
candidatesOf(const ModelSurvey& survey, const SurveyedBridges& joined)
{
  std::map<CurvePair, std::vector<std::size_t>> bridges_of;
  for (std::size_t b = joined.bridges.size(); b-- > 0;) // the best was chosen first
    bridges_of[curvesOf(joined.bridges[b])].push_back(b);
  std::vector<const Junction*> junctions;
  for (const Junction& junction : joined.junctions)
    if (bridges_of.count(junction.curves) > 0 && !isWanted(junction, survey) &&
        joined.ahead[joined.loops[junction.curves[0]]] !=
            joined.loops[junction.curves[1]] &&
        bendOf(junction) > MOST_BENT && junction.evidence.logOdds() < CARRYING_ODDS)
      junctions.push_back(&junction);
  std::stable_sort(
      junctions.begin(), junctions.end(), [](const Junction* a, const Junction* b) {
        return bendOf(*a) > bendOf(*b);
      });
  std::vector<Candidate> candidates;
  for (const Junction* junction : junctions)
    for (const std::size_t bridge : bridges_of.at(junction->curves))
      candidates.push_back({junction, bridge});
  if (candidates.size() > MOST_TRIES)
    candidates.resize(MOST_TRIES);
  if (junctions.size() > MOST_TRIES)
    junctions.resize(MOST_TRIES);
  for (const Junction* junction : junctions)
    candidates.push_back({junction, NONE});
  return candidates;
}

} // namespace

BridgedTopology
bridgedTopology(const ModelSurvey& survey, const SurveyedBridges& joined)
{
  const auto island_at = [&](const BoundaryPoint& end) {
    return survey.loops[joined.loops[end.curve]].island;
  };
  const std::size_t islands = survey.model.islands.size();
  ccaa::DisjointSets sets(islands);
  long bridges = 0; // each is passed twice
  for (const HoleContour& contour : joined.holes.contours)
    for (const ContourStep& step : contour.steps)
      if (step.bridge != NONE) {
        const Bridge& bridge = joined.bridges[step.bridge];
        sets.join(island_at(bridge.begin), island_at(bridge.end));
        ++bridges;
      }
  BridgedTopology topology;
  for (std::size_t i = 0; i < islands; ++i)
    topology.pieces += sets.isRoot(i) ? 1 : 0;
  const auto contours = static_cast<long>(joined.holes.contours.size());
  const auto boundaries = static_cast<long>(joined.loops.size());
  topology.handles = static_cast<long>(topology.pieces) - static_cast<long>(islands) -
                     (contours - bridges / 2 - boundaries) / 2;
  return topology;
}

void
dropHandles(const ModelSurvey& survey,
            const BoundaryEdges& boundaries,
            SurveyedBridges& joined)
{
  BridgedTopology now = bridgedTopology(survey, joined);
  std::size_t tries = 0;
  for (bool dropped = true; dropped && now.handles > 0;) {
    dropped = false;
    const BridgeSides sides(joined);
    for (const Candidate& candidate : candidatesOf(survey, joined)) {
      const auto is_dropped = [&](std::size_t bridge) {
        return candidate.bridge == NONE
                   ? curvesOf(joined.bridges[bridge]) == candidate.junction->curves
                   : bridge == candidate.bridge;
      };
      if (!sides.mayTakeHandle(is_dropped))
        continue;
      if (++tries > MOST_EXTRACTIONS)
        return;
      SurveyedBridges left = without(is_dropped, boundaries, joined);
      const BridgedTopology then = bridgedTopology(survey, left);
      if (then.pieces != now.pieces || then.handles >= now.handles)
        continue;
      joined.bridges = std::move(left.bridges);
      joined.holes = std::move(left.holes);
      now = then;
      dropped = true;
      break;
    }
  }
}

} // namespace repair
} // namespace pcl
