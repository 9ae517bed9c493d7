// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what junctions, and pieces without one, leave in doubt.

#include "verification/junction_doubts.h"

#include <pcl/surface_repair/decisions.h>

#include "boundary/boundary_loop.h"
#include "junction/junction.h"
#include "mesh/thin_necks.h"
#include "survey/handle_choice.h"

#include <algorithm>
#include <map>

namespace pcl::repair {

namespace {

/** Log odds above those from which junctions are joined that leave no doubt: below it
 * two of five models came out wrong, and none of 40 where the least likely one was up
 * to 1.5 above. */
constexpr double MARGIN = 0.35;
/** The same in what sensors have seen: below it a third of the junctions that are
 * joined in generated range maps (10 of 28) is wrong, above it 6 % (23 of 409). */
constexpr double SEEN_MARGIN = 0.75;

/** Log odds that two mouths may lack to be joined, and may belong together yet. */
constexpr double LACK = 1.0;

bool
isWeak(const JunctionEvidence& evidence, const JunctionParameters& parameters)
{
  const double margin = evidence.has_sight ? SEEN_MARGIN : MARGIN;
  return evidence.logOdds() < oddsThatJoin(evidence, parameters) + margin;
}

/** Whether a junction may have made a handle that it does not carry. */
bool
mayBeFalseHandle(const RepairJunction& junction, const RepairReport& report)
{
  return report.after.genus.value_or(0) > 0 &&
         junction.islands[0] == junction.islands[1] &&
         !surelyCarriesHandle(junction.evidence);
}

/** Of new triangles, and so many edges around these, ascending. */
std::vector<pcl::index_t>
verticesNearNew(const RepairedModel& repaired, int edges)
{
  const IncompleteModel& model = repaired.model;
  std::vector<bool> is_near(model.positions.size(), false);
  std::vector<pcl::index_t> near;
  const auto addCorners = [&](std::size_t triangle) {
    for (const pcl::index_t vertex : model.triangles[triangle]) {
      if (!is_near[static_cast<std::size_t>(vertex)])
        near.push_back(vertex);
      is_near[static_cast<std::size_t>(vertex)] = true;
    }
  };
  for (std::size_t t = repaired.input_triangles; t < model.triangles.size(); ++t)
    addCorners(t);
  std::size_t first = 0;
  for (int ring = 0; ring < edges; ++ring)
    for (const std::size_t last = near.size(); first < last; ++first)
      for (const pcl::index_t* t = model.adjacency.begin(near[first]);
           t != model.adjacency.end(near[first]);
           ++t)
        addCorners(static_cast<std::size_t>(*t));
  std::sort(near.begin(), near.end());
  return near;
}

} // namespace

std::set<PointPair>
decidedLoops(const Decisions* decisions, bool join)
{
  std::set<PointPair> pairs;
  if (decisions == nullptr)
    return pairs;
  for (const JunctionDecision& junction : decisions->junctions)
    if (junction.join == join)
      pairs.insert(inOrder(decisions->loops[junction.first_loop].key.point,
                           decisions->loops[junction.second_loop].key.point));
  return pairs;
}

bool
areSettled(const Decisions* decisions)
{
  return decisions != nullptr && decisions->settles_doubts;
}

std::vector<RepairDoubt>
weakJunctions(const RepairReport& report, const SurveyParameters& parameters)
{
  const std::set<PointPair> wanted = decidedLoops(parameters.decisions.get(), true);
  std::map<PointPair, double> gaps;
  for (const RepairJunction& junction : report.junctions) {
    const PointPair points = inOrder(junction.points[0], junction.points[1]);
    if (parameters.junction.judge && junction.verdict == JunctionVerdict::JOINED &&
        (isWeak(junction.evidence, parameters.junction) ||
         mayBeFalseHandle(junction, report)) &&
        wanted.count(points) == 0)
      gaps[points] = junction.evidence.gap_share;
  }
  std::vector<RepairDoubt> weak;
  for (const auto& [points, gap] : gaps)
    weak.push_back({DoubtReason::LONG_GAP, points, gap});
  return weak;
}

std::vector<RepairDoubt>
unjoinedMouths(const RepairReport& report, const SurveyParameters& parameters)
{
  std::set<pcl::index_t> joined;
  std::map<PointPair, double> gaps;
  for (const RepairJunction& junction : report.junctions) {
    const PointPair points = inOrder(junction.points[0], junction.points[1]);
    if (junction.verdict == JunctionVerdict::JOINED)
      joined.insert(points.begin(), points.end());
    else if (const double lack = oddsThatJoin(junction.evidence, parameters.junction) -
                                 junction.evidence.logOdds();
             junction.between_mouths && lack > 0.0 && lack < LACK)
      gaps[points] = junction.evidence.gap_share;
  }
  const std::set<PointPair> apart = decidedLoops(parameters.decisions.get(), false);
  std::vector<RepairDoubt> unjoined;
  for (const auto& [points, gap] : gaps)
    if (apart.count(points) == 0 && joined.count(points[0]) == 0 &&
        joined.count(points[1]) == 0)
      unjoined.push_back({DoubtReason::UNJOINED, points, gap});
  return unjoined;
}

std::vector<RepairDoubt>
partedJunctions(const IncompleteModel& model,
                const RepairReport& report,
                const SurveyParameters& parameters)
{
  if (report.after.pieces < 2 || !parameters.junction.judge ||
      parameters.decisions != nullptr || parameters.greatest_bridge.limits())
    return {};
  std::map<PointPair, double> gaps;
  std::map<pcl::index_t, std::size_t> piece_at; // a point
  for (const RepairJunction& junction : report.junctions)
    if (junction.verdict == JunctionVerdict::JOINED) {
      const PointPair points = inOrder(junction.points[0], junction.points[1]);
      gaps[points] = junction.evidence.gap_share;
      piece_at[points[0]] = piece_at[points[1]] = NONE;
    }
  visitPieces(model, piece_at, [&](pcl::index_t point, std::size_t piece) {
    piece_at.at(point) = piece;
  });
  std::vector<RepairDoubt> parted;
  for (const auto& [points, gap] : gaps) {
    const std::size_t low = piece_at.at(points[0]), high = piece_at.at(points[1]);
    if (low != NONE && high != NONE && low != high)
      parted.push_back({DoubtReason::PARTED, points, gap});
  }
  return parted;
}

std::vector<RepairDoubt>
newNecks(const RepairedModel& repaired, const SurveyParameters& parameters)
{
  if (areSettled(parameters.decisions.get()))
    return {};
  const IncompleteModel& model = repaired.model;
  const std::vector<pcl::index_t> near_new =
      verticesNearNew(repaired, ccaa::EDGES_AROUND_NECK);
  std::vector<RepairDoubt> necks;
  for (const ccaa::ThinNeck& neck : ccaa::thinNecks(
           model.triangles, model.adjacency, model.positions, {}, &near_new))
    if (!neck.is_handle)
      necks.push_back(
          {DoubtReason::THIN_NECK,
           {model.point_of_vertex[static_cast<std::size_t>(neck.vertex)], -1},
           0.0});
  return necks;
}

} // namespace pcl::repair
