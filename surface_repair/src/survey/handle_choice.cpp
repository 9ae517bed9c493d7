// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: handles that bridges make, counted before anything is
// filled.

#include "survey/handle_choice.h"

#include "boundary/loop_evidence.h"
#include "mesh/disjoint_sets.h"
#include "survey/bridge_strips.h"
#include "survey/wanted_lines.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::repair {

namespace {

/** Turn and fold together, in radians, and log odds: a junction that is more bent and
 * less likely may not make a handle. At true cuts through skull, rocker arm and
 * daratech the bend is up to 92 degrees, at false ones 150 and more with odds of up
 * to 3.5; a coarse torus has 120 with odds of 3.9. */
constexpr double MOST_BENT = 2.1;
constexpr double CARRYING_ODDS = 3.6;
/** Bend from which these odds are not sure, 130 degrees, and odds that are: of 12 out
 * of 770 damaged models with such a handle in between three are right. */
constexpr double FAR_BENT = 2.27;
constexpr double SURE_ODDS = 4.3;
/** Gap in the extent of the smaller boundary over which a mouth tells nothing of where
 * its tube goes on. */
constexpr double WIDEST_GAP = 1.0;
/** Junctions that are tried for each handle. */
constexpr std::size_t MOST_TRIES = 64;
/** Times in all that contours are extracted anew. */
constexpr std::size_t MOST_EXTRACTIONS = 1024;
/** Operations for a bridge and for a boundary, to try whether a handle goes, and to
 * extract contours anew. */
constexpr std::uint64_t TRIAL_WORK = 5;
constexpr std::uint64_t EXTRACTION_WORK = 200;

double
bendOf(const JunctionEvidence& evidence)
{
  return evidence.turn + evidence.fold;
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

/** Those that have bridges and that nobody wants, as far as a rule takes them, where no
 * mouth looks at the other boundary; the least one first. */
template <typename Rule, typename Less>
std::vector<const Junction*>
yieldingJunctions(const ModelSurvey& survey,
                  const SurveyedBridges& joined,
                  const Strips& strips,
                  const Rule& takes,
                  const Less& less)
{
  std::vector<const Junction*> junctions;
  for (const Junction& junction : joined.junctions)
    if (strips.count(junction.curves) > 0 && !isWanted(junction, survey) &&
        joined.ahead[joined.loops[junction.curves[0]]] !=
            joined.loops[junction.curves[1]] &&
        takes(junction))
      junctions.push_back(&junction);
  std::stable_sort(junctions.begin(), junctions.end(), less);
  return junctions;
}

bool
isLessLikely(const Junction* a, const Junction* b)
{
  return a->evidence.logOdds() < b->evidence.logOdds();
}

/** Narrow strips of junctions that are not sure, of the least likely ones first. */
std::vector<Bridges>
narrowStrips(const ModelSurvey& survey,
             const SurveyedBridges& joined,
             const Strips& strips)
{
  const auto isUnsure = [](const Junction& junction) {
    return junction.evidence.logOdds() < CARRYING_ODDS;
  };
  std::vector<Bridges> narrow;
  for (const Junction* junction :
       yieldingJunctions(survey, joined, strips, isUnsure, isLessLikely))
    for (const Strip& strip : strips.at(junction->curves))
      if (strip.isNarrow() && narrow.size() < MOST_TRIES)
        narrow.push_back(strip.bridges);
  return narrow;
}

/** Whether without some bridges a mouth would be capped over which a tube goes on: they
 * are all that it has, and more than a narrow strip. */
bool
wouldCapMouth(const Bridges& bridges,
              const Junction& junction,
              const ModelSurvey& survey,
              const SurveyedBridges& joined)
{
  const auto isOnlyAt = [&](std::size_t curve) {
    return static_cast<std::size_t>(std::count_if(
               joined.bridges.begin(), joined.bridges.end(), [&](const Bridge& bridge) {
                 return bridge.begin.curve == curve || bridge.end.curve == curve;
               })) == bridges.size();
  };
  return bridges.size() > ISTHMUS && junction.evidence.gap_share <= WIDEST_GAP &&
         std::any_of(
             junction.curves.begin(), junction.curves.end(), [&](std::size_t curve) {
               return isMouth(survey.classes[joined.loops[curve]].evidence) &&
                      isOnlyAt(curve);
             });
}

/** Bridges that may be given up together: of each junction single strips, so that most
 * can stay, then all.
 * \param[in] of_sure_ones of junctions that may make a handle, the least likely ones
 * first; else of those that may not, the most bent ones first */
std::vector<Bridges>
candidatesOf(const ModelSurvey& survey,
             const SurveyedBridges& joined,
             bool of_sure_ones)
{
  const Strips strips = stripsOf(joined);
  std::vector<const Junction*> junctions = yieldingJunctions(
      survey,
      joined,
      strips,
      [&](const Junction& junction) {
        return carriesHandle(junction.evidence) == of_sure_ones;
      },
      [&](const Junction* a, const Junction* b) {
        return of_sure_ones ? isLessLikely(a, b)
                            : bendOf(a->evidence) > bendOf(b->evidence);
      });
  if (junctions.size() > MOST_TRIES)
    junctions.resize(MOST_TRIES);
  std::vector<Bridges> candidates;
  if (!of_sure_ones)
    candidates = narrowStrips(survey, joined, strips);
  const auto add = [&](Bridges bridges, const Junction& junction) {
    if (!wouldCapMouth(bridges, junction, survey, joined))
      candidates.push_back(std::move(bridges));
  };
  for (const Junction* junction : junctions) {
    const std::vector<Strip>& some = strips.at(junction->curves);
    for (const Strip& strip : some)
      add(strip.bridges, *junction);
    if (some.size() == 1) // which is all
      continue;
    Bridges all;
    for (const Strip& strip : some)
      all.insert(all.end(), strip.bridges.begin(), strip.bridges.end());
    std::sort(all.begin(), all.end());
    add(std::move(all), *junction);
  }
  return candidates;
}

class HandleDropping {
public:
  HandleDropping(const ModelSurvey& survey,
                 const BoundaryEdges& boundaries,
                 SurveyedBridges& joined,
                 ccaa::RunControl* control)
  : survey_(survey)
  , boundaries_(boundaries)
  , joined_(joined)
  , control_(control)
  , now_(bridgedTopology(survey, joined))
  {}

  /** \param[in] in_gap only a handle of the new surface alone, of any junction
   * \return whether there is one less */
  bool
  dropOne(bool in_gap)
  {
    if ((in_gap ? now_.in_gaps : now_.handles) <= 0)
      return false;
    const BridgeSides sides(joined_);
    for (const Bridges& candidate : candidatesOf(survey_, joined_, in_gap)) {
      const auto is_dropped = [&](std::size_t bridge) {
        return std::binary_search(candidate.begin(), candidate.end(), bridge);
      };
      const std::uint64_t size = joined_.bridges.size() + survey_.loops.size();
      if (!ccaa::spend(control_, TRIAL_WORK * size))
        return false;
      if (!sides.mayTakeHandle(is_dropped))
        continue;
      if (++tries_ > MOST_EXTRACTIONS || !ccaa::spend(control_, EXTRACTION_WORK * size))
        return false;
      SurveyedBridges left = without(is_dropped, boundaries_, joined_);
      const BridgedTopology then = bridgedTopology(survey_, left);
      if (then.pieces != now_.pieces || then.handles >= now_.handles ||
          (in_gap && then.in_gaps >= now_.in_gaps))
        continue;
      joined_.bridges = std::move(left.bridges);
      joined_.holes = std::move(left.holes);
      now_ = then;
      return true;
    }
    return false;
  }

private:
  const ModelSurvey& survey_;
  const BoundaryEdges& boundaries_;
  SurveyedBridges& joined_;
  ccaa::RunControl* control_;
  BridgedTopology now_;
  std::size_t tries_ = 0;
};

} // namespace

bool
carriesHandle(const JunctionEvidence& evidence)
{
  return bendOf(evidence) <= MOST_BENT || evidence.logOdds() >= CARRYING_ODDS;
}

bool
surelyCarriesHandle(const JunctionEvidence& evidence)
{
  return carriesHandle(evidence) &&
         (bendOf(evidence) <= FAR_BENT || evidence.logOdds() >= SURE_ODDS);
}

BridgedTopology
bridgedTopology(const ModelSurvey& survey, const SurveyedBridges& joined)
{
  const auto island_at = [&](const BoundaryPoint& end) {
    return survey.loops[joined.loops[end.curve]].island;
  };
  const std::size_t islands = survey.model.islands.size();
  ccaa::DisjointSets pieces(islands);
  ccaa::DisjointSets gaps(joined.loops.size());
  long bridges = 0; // each is passed twice
  for (const HoleContour& contour : joined.holes.contours)
    for (const ContourStep& step : contour.steps)
      if (step.bridge != NONE) {
        const Bridge& bridge = joined.bridges[step.bridge];
        pieces.join(island_at(bridge.begin), island_at(bridge.end));
        gaps.join(bridge.begin.curve, bridge.end.curve);
        ++bridges;
      }
  BridgedTopology topology;
  topology.pieces = pieces.count();
  const auto boundaries = static_cast<long>(joined.loops.size());
  const long discs = static_cast<long>(joined.holes.contours.size()) - bridges / 2;
  topology.handles = static_cast<long>(topology.pieces) - static_cast<long>(islands) -
                     (discs - boundaries) / 2;
  topology.in_gaps = static_cast<long>(gaps.count()) - (discs + boundaries) / 2;
  return topology;
}

void
dropHandles(const ModelSurvey& survey,
            const BoundaryEdges& boundaries,
            SurveyedBridges& joined,
            ccaa::RunControl* control)
{
  HandleDropping dropping(survey, boundaries, joined, control);
  while (dropping.dropOne(false) || dropping.dropOne(true))
    continue;
}

} // namespace pcl::repair
