// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which force lines may become bridges between islands.

#include "survey/wanted_lines.h"

#include <limits>
#include <set>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** The lines of a junction that may become bridges, were it not for the user's limits.
 */
const std::vector<std::size_t>&
linesOf(const Junction& junction, const ModelSurvey& survey)
{
  const auto loop = [&](std::size_t end) -> const BoundaryLoop& {
    return survey.loops[survey.joined.loops[junction.curves[end]]];
  };
  const bool is_forced = junction.verdict != JunctionVerdict::JOINED &&
                         survey.wishes.mustJoin(survey.model, loop(0), loop(1));
  return is_forced ? junction.lines : junction.believed;
}

bool
mayBeJoined(const Junction& junction, const ModelSurvey& survey)
{
  const auto loop = [&](std::size_t end) -> const BoundaryLoop& {
    return survey.loops[survey.joined.loops[junction.curves[end]]];
  };
  return !survey.wishes.keepApart() ||
         survey.wishes.mayJoin(survey.model, loop(0), loop(1));
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
                             [other](std::size_t c, std::size_t) { return c == other; })
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

std::vector<ForceLine>
wantedChords(const ModelSurvey& survey, const BoundaryEdges& boundaries, double spacing)
{
  std::vector<ForceLine> chords;
  if (!survey.wishes.anyJoined())
    return chords;
  const std::vector<std::size_t>& loops = survey.joined.loops;
  std::set<std::pair<std::size_t, std::size_t>> connected;
  for (const ForceLine& line : survey.between_islands.lines)
    if (line.end == LineEnd::BRIDGE)
      connected.insert(std::minmax(line.origin.curve, line.target.curve));
  for (std::size_t a = 0; a < loops.size(); ++a)
    for (std::size_t b = a + 1; b < loops.size(); ++b) {
      const BoundaryLoop& first = survey.loops[loops[a]];
      const BoundaryLoop& second = survey.loops[loops[b]];
      if (connected.count({a, b}) > 0 ||
          !survey.wishes.mustJoin(survey.model, first, second))
        continue;
      const bool is_shorter = first.curve.size() <= second.curve.size();
      const std::size_t from = is_shorter ? a : b;
      for (std::size_t e = 0; e < boundaries.curves()[from].curve.size(); ++e)
        chords.push_back(
            resampled(chordFrom(boundaries, from, e, is_shorter ? b : a), spacing));
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

} // namespace repair
} // namespace pcl
