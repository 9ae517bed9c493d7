// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which force lines may become bridges between islands.

#include "survey/wanted_lines.h"

#include <limits>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

const BoundaryLoop&
loopOf(const Junction& junction, std::size_t end, const ModelSurvey& survey)
{
  return survey.loops[survey.joined.loops[junction.curves[end]]];
}

/** The lines of a junction that may become bridges, were it not for the user's limits.
 */
const std::vector<std::size_t>&
linesOf(const Junction& junction, const ModelSurvey& survey)
{
  const bool is_forced =
      junction.verdict != JunctionVerdict::JOINED && isWanted(junction, survey);
  return is_forced ? junction.lines : junction.believed;
}

bool
mayBeJoined(const Junction& junction, const ModelSurvey& survey)
{
  return !survey.wishes.keepApart() ||
         survey.wishes.mayJoin(
             survey.model, loopOf(junction, 0, survey), loopOf(junction, 1, survey));
}

/** A straight line from the middle of an edge. At its ends the surface turns about the
 * boundary into the line, and its normal turns along. */
ForceLine
chordFrom(const BoundaryEdges& boundaries,
          std::size_t curve,
          std::size_t edge,
          std::size_t other)
{
  ForceLine line;
  line.origin = boundaries.pointAt(curve, boundaries.arcOfEdge(curve, edge));
  const Position& from = line.origin.position;
  line.target = boundaries
                    .closest(from,
                             from,
                             std::numeric_limits<double>::max(),
                             [other](std::size_t c) { return c == other; })
                    ->point;
  const Position& to = line.target.position;
  const auto normalAt = [&](const BoundaryPoint& end, const Eigen::Vector3d& way) {
    return way.cross(boundaries.curves()[end.curve].curve.edge(end.edge)).normalized();
  };
  line.end = LineEnd::BRIDGE;
  line.length = (to - from).norm();
  line.points = {from, to};
  line.normals = {normalAt(line.origin, to - from), normalAt(line.target, from - to)};
  line.tensions = {0.0, 0.0};
  return line;
}

} // namespace

std::set<std::pair<std::size_t, std::size_t>>
wantedPairs(const ModelSurvey& survey)
{
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  if (survey.wishes.joined().empty())
    return pairs;
  std::map<std::size_t, std::size_t> loop_of; // of the input
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    loop_of[survey.wishes.inputLoop(survey.model, survey.loops[k])] = k;
  for (const auto& [low, high] : survey.wishes.joined())
    if (loop_of.count(low) > 0 && loop_of.count(high) > 0)
      pairs.insert(std::minmax(loop_of[low], loop_of[high]));
  return pairs;
}

bool
isWanted(const Junction& junction, const ModelSurvey& survey)
{
  return survey.wishes.mustJoin(
      survey.model, loopOf(junction, 0, survey), loopOf(junction, 1, survey));
}

std::vector<ForceLine>
wantedChords(const ModelSurvey& survey, const BoundaryEdges& boundaries, double spacing)
{
  std::map<std::size_t, std::size_t> curve_of; // of a loop
  for (std::size_t curve = 0; curve < survey.joined.loops.size(); ++curve)
    curve_of[survey.joined.loops[curve]] = curve;
  std::set<std::pair<std::size_t, std::size_t>> connected;
  for (const ForceLine& line : survey.between_islands.lines)
    if (line.end == LineEnd::BRIDGE)
      connected.insert(std::minmax(line.origin.curve, line.target.curve));
  std::vector<ForceLine> chords;
  for (const auto& [first, second] : wantedPairs(survey)) {
    if (curve_of.count(first) == 0 || curve_of.count(second) == 0)
      continue;
    std::size_t from = curve_of[first];
    std::size_t to = curve_of[second];
    if (connected.count(std::minmax(from, to)) > 0)
      continue;
    if (survey.loops[second].curve.size() < survey.loops[first].curve.size())
      std::swap(from, to);
    for (std::size_t e = 0; e < boundaries.curves()[from].curve.size(); ++e)
      chords.push_back(resampled(chordFrom(boundaries, from, e, to), spacing));
  }
  return chords;
}

double
diagonalOf(const IncompleteModel& model)
{
  Eigen::AlignedBox3d box;
  for (const Island& island : model.islands)
    box.extend(island.box);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

std::vector<ForceLine>
wantedLines(const ModelSurvey& survey,
            const SurveyParameters& parameters,
            std::vector<std::size_t>& refused)
{
  const double longest =
      parameters.greatest_bridge.limits()
          ? parameters.greatest_bridge.length(diagonalOf(survey.model))
          : std::numeric_limits<double>::infinity();
  const SurveyedBridges& joined = survey.joined;
  const std::vector<ForceLine>& lines = survey.between_islands.lines;
  std::set<std::size_t> wanted;
  std::set<std::size_t> not_wanted;
  for (const Junction& junction : joined.junctions) {
    const bool may_be_joined = mayBeJoined(junction, survey);
    for (const std::size_t line : linesOf(junction, survey))
      if (may_be_joined && lines[line].length <= longest)
        wanted.insert(line);
      else
        for (const std::size_t curve : junction.curves)
          not_wanted.insert(joined.loops[curve]);
  }
  refused.assign(not_wanted.begin(), not_wanted.end());
  std::vector<ForceLine> list;
  for (const std::size_t line : wanted)
    list.push_back(lines[line]);
  return list;
}

} // namespace pcl::repair
