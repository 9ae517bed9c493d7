// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lines and bridges between islands, until each that can be
// reached is reached (4.47).

#include "survey/crease_bridges.h"
#include "survey/handle_choice.h"
#include "survey/lone_stumps.h"
#include "survey/survey_fields.h"
#include "survey/touching_points.h"
#include "survey/wanted_lines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Times that lines are traced anew where an island has lost its bridges, each time
 * with origins so much closer to each other. */
constexpr int MORE_ROUNDS = 2;
constexpr double CLOSER = 0.25;
/** Operations for a possible origin, to find the strongest. */
constexpr std::uint64_t ORIGIN_WORK = 20;
/** Operations for a line, to choose bridges among them. */
constexpr std::uint64_t CHOICE_WORK = 1000;
/** Lengths of a lost line around its ends where new ones begin. */
constexpr double AROUND = 1.5;

class Joining {
public:
  Joining(const IslandSources& islands,
          const SurveyParameters& parameters,
          const ccaa::LoopContext& context,
          ModelSurvey& survey)
  : parameters_(parameters)
  , context_(context)
  , survey_(survey)
  , spacing_(islands.sources.spacing)
  , targets_(targetsOf(islands.sources, survey.loops))
  , field_(makeField(islands.sources, parameters.field, *survey.guides))
  , ends_(survey.model)
  {
    survey_.joined.ahead = islands.ahead;
    for (const SourceCurve& curve : islands.sources.curves)
      survey_.joined.loops.push_back(curve.loop);
  }

  void
  run();

private:
  void
  traceFrom(const std::vector<PossibleOrigin>& origins, double apart);
  void
  choose();
  std::vector<PossibleOrigin>
  originsAtLostIslands() const;

  std::vector<ForceLine>&
  lines()
  {
    return survey_.between_islands.lines;
  }

  const SurveyParameters& parameters_;
  const ccaa::LoopContext& context_;
  ModelSurvey& survey_;
  double spacing_;
  BoundaryEdges targets_;
  IndicatorField field_;
  SurfaceEnds ends_;
  std::set<std::pair<std::size_t, double>> traced_; /**< curve and arc of origins */
};

/** Lines that begin where one began before would be the same. */
void
Joining::traceFrom(const std::vector<PossibleOrigin>& origins, double apart)
{
  std::vector<LineOrigin> chosen;
  ccaa::spend(context_.control, ORIGIN_WORK * origins.size());
  for (const std::size_t i : strongestOrigins(origins, targets_, apart)) {
    const BoundaryPoint& point = origins[i].origin.point;
    if (traced_.emplace(point.curve, targets_.arcAt(point)).second)
      chosen.push_back(origins[i].origin);
  }
  std::vector<ForceLine> found =
      traceLines({field_, targets_, *survey_.guides}, chosen, parameters_, context_);
  std::move(found.begin(), found.end(), std::back_inserter(lines()));
}

void
Joining::choose()
{
  SurveyedBridges& joined = survey_.joined;
  joined.junctions = findJunctions(ends_,
                                   survey_.loops,
                                   joined.loops,
                                   targets_,
                                   lines(),
                                   survey_.sight.get(),
                                   survey_.facing,
                                   parameters_.junction,
                                   context_.control);
  if (context_.cancelled())
    return;
  joinLoneStumps(parameters_.junction, survey_);
  const std::vector<Bridge> creases = creaseBridges(survey_, targets_, ends_);
  const std::vector<Bridge> along_lines =
      selectBridges(wantedLines(survey_, parameters_, joined.refused),
                    targets_,
                    {parameters_.bridge_spacing, 2.0 * spacing_},
                    creases);
  joined.bridges = touchingBridges(survey_, targets_);
  joined.bridges.insert(joined.bridges.end(), creases.begin(), creases.end());
  joined.bridges.insert(joined.bridges.end(), along_lines.begin(), along_lines.end());
  ccaa::spend(context_.control, CHOICE_WORK * lines().size());
  survey_.joined.holes = extractContours(targets_, survey_.joined.bridges);
  dropHandles(survey_, targets_, survey_.joined, context_.control);
}

/** Origins on boundaries that lines reach but no bridge that could be kept, and around
 * the other ends of those lines. */
std::vector<PossibleOrigin>
Joining::originsAtLostIslands() const
{
  std::vector<bool> has_bridge(targets_.curves().size(), false);
  const SurveyedBridges& joined = survey_.joined;
  const auto& removed = joined.holes.removed_bridges;
  for (std::size_t b = 0; b < joined.bridges.size(); ++b)
    if (!std::binary_search(removed.begin(), removed.end(), b))
      has_bridge[joined.bridges[b].begin.curve] =
          has_bridge[joined.bridges[b].end.curve] = true;
  std::vector<std::pair<BoundaryPoint, double>> ends; // and how far around them
  for (const ForceLine& line : survey_.between_islands.lines)
    if (line.end == LineEnd::BRIDGE &&
        !(has_bridge[line.origin.curve] && has_bridge[line.target.curve]))
      for (const BoundaryPoint* end : {&line.origin, &line.target})
        ends.emplace_back(*end, AROUND * line.length);
  std::vector<PossibleOrigin> origins;
  for (const PossibleOrigin& origin : survey_.between_islands.origins) {
    const BoundaryPoint& point = origin.origin.point;
    if (std::any_of(ends.begin(), ends.end(), [&](const auto& end) {
          return end.first.curve == point.curve &&
                 (end.first.position - point.position).norm() <= end.second;
        }))
      origins.push_back(origin);
  }
  return origins;
}

void
Joining::run()
{
  survey_.between_islands.origins =
      originsBetweenIslands(field_, targets_, reachOf(parameters_.field), context_);
  double apart = parameters_.line_spacing;
  traceFrom(survey_.between_islands.origins, apart);
  if (context_.cancelled())
    return;
  std::vector<ForceLine> chords = wantedChords(survey_, targets_, spacing_);
  std::move(chords.begin(), chords.end(), std::back_inserter(lines()));
  choose();
  for (int round = 0; round < MORE_ROUNDS && !context_.cancelled(); ++round) {
    apart *= CLOSER;
    const std::size_t before = lines().size();
    traceFrom(originsAtLostIslands(), apart);
    if (lines().size() > before)
      choose();
  }
}

} // namespace

void
joinIslands(const IslandSources& islands,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            ModelSurvey& survey)
{
  Joining(islands, parameters, context, survey).run();
}

} // namespace pcl::repair
