// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which force lines may become bridges between islands.

#include "survey/wanted_lines.h"

#include <limits>
#include <set>

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

} // namespace

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
