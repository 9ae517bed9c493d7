// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stumps of limbs that have one partner only.

#include "survey/lone_stumps.h"

#include "boundary/loop_evidence.h"
#include "boundary/opposed_loops.h"

#include <algorithm>
#include <limits>

namespace pcl::repair {

namespace {

/** Log odds that a junction without an alternative may lack. */
constexpr double LONE_ODDS = 1.5;
/** Log odds by which it is better than any other one. */
constexpr double LEAST_MARGIN = 0.5;

/** The junctions of a curve. */
struct Partners {
  std::size_t best = NONE;
  double odds = -std::numeric_limits<double>::infinity();
  double next_odds = -std::numeric_limits<double>::infinity();
};

/** For each island how many loops it has. */
std::vector<std::size_t>
loopCounts(const ModelSurvey& survey)
{
  std::vector<std::size_t> counts(survey.model.islands.size(), 0);
  for (const BoundaryLoop& loop : survey.loops)
    ++counts[loop.island];
  return counts;
}

/** Whether the islands of both curves are ends of limbs that were cut off side by side,
 * such as fingertips: joined, they would be a body of their own. Where the junction is
 * doubtful anyway, they are if they do not look at each other. */
bool
areTipsSideBySide(const Junction& junction,
                  const std::vector<std::size_t>& loop_counts,
                  const ModelSurvey& survey)
{
  const bool is_doubtful = junction.verdict != JunctionVerdict::JOINED;
  const std::size_t first = survey.joined.loops[junction.curves[0]];
  const std::size_t second = survey.joined.loops[junction.curves[1]];
  const auto isTip = [&](std::size_t loop) {
    return loop_counts[survey.loops[loop].island] == 1 &&
           (is_doubtful || isMouth(survey.classes[loop].evidence));
  };
  return survey.loops[first].island != survey.loops[second].island && isTip(first) &&
         isTip(second) &&
         lookTheSameWay(survey.loops[first].curve,
                        survey.loops[second].curve,
                        is_doubtful ? 0.0 : SAME_WAY);
}

/** \return flags of the junctions that are none */
std::vector<bool>
partTips(const std::vector<std::size_t>& loop_counts, ModelSurvey& survey)
{
  std::vector<bool> are_parted;
  for (Junction& junction : survey.joined.junctions) {
    are_parted.push_back(areTipsSideBySide(junction, loop_counts, survey));
    if (are_parted.back() && junction.verdict == JunctionVerdict::JOINED) {
      junction.verdict = JunctionVerdict::DOUBTFUL;
      junction.believed.clear();
    }
  }
  return are_parted;
}

/** Whether a loop is a mouth, or a stump without which its island would be a piece of
 * its own. */
bool
mustGoOn(std::size_t loop,
         const std::vector<std::size_t>& loop_counts,
         const ModelSurvey& survey)
{
  const LoopEvidence& evidence = survey.classes[loop].evidence;
  return isMouth(evidence) ||
         (loop_counts[survey.loops[loop].island] == 1 && mayBeStump(evidence) &&
          evidence.integral.relative() > 0.0);
}

std::vector<Partners>
partnersOfCurves(const SurveyedBridges& joined, const std::vector<bool>& are_parted)
{
  std::vector<Partners> partners(joined.loops.size());
  for (std::size_t j = 0; j < joined.junctions.size(); ++j) {
    if (are_parted[j])
      continue;
    const double odds = joined.junctions[j].evidence.logOdds();
    for (const std::size_t curve : joined.junctions[j].curves) {
      Partners& own = partners[curve];
      own.next_odds = std::max(own.next_odds, std::min(odds, own.odds));
      if (odds > own.odds) {
        own.odds = odds;
        own.best = j;
      }
    }
  }
  return partners;
}

} // namespace

void
joinLoneStumps(const JunctionParameters& parameters, ModelSurvey& survey)
{
  if (!isSeenFromAllSides(survey.facing))
    return;
  SurveyedBridges& joined = survey.joined;
  const std::vector<std::size_t> loop_counts = loopCounts(survey);
  const std::vector<Partners> partners =
      partnersOfCurves(joined, partTips(loop_counts, survey));
  for (std::size_t curve = 0; curve < partners.size(); ++curve) {
    const Partners& own = partners[curve];
    if (own.best == NONE || !mustGoOn(joined.loops[curve], loop_counts, survey) ||
        own.odds < parameters.joined_from - LONE_ODDS ||
        own.odds < own.next_odds + LEAST_MARGIN)
      continue;
    Junction& junction = joined.junctions[own.best];
    const std::size_t other = junction.curves[junction.curves[0] == curve ? 1 : 0];
    if (junction.verdict != JunctionVerdict::DOUBTFUL ||
        partners[other].best != own.best)
      continue;
    junction.verdict = JunctionVerdict::JOINED;
    junction.believed = junction.lines;
    junction.confidence = 0.0;
  }
}

} // namespace pcl::repair
