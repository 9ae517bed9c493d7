// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stumps of limbs that have one partner only.

#include "survey/lone_stumps.h"

#include "boundary/loop_evidence.h"

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

std::vector<Partners>
partnersOfCurves(const SurveyedBridges& joined)
{
  std::vector<Partners> partners(joined.loops.size());
  for (std::size_t j = 0; j < joined.junctions.size(); ++j) {
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
  const std::vector<Partners> partners = partnersOfCurves(joined);
  for (std::size_t curve = 0; curve < partners.size(); ++curve) {
    const Partners& own = partners[curve];
    if (own.best == NONE || !isMouth(survey.classes[joined.loops[curve]].evidence) ||
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
