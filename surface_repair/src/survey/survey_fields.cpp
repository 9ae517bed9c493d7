// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fields of a survey, and what they are made of.

#include "survey/survey_fields.h"

#include "boundary/loop_evidence.h"
#include "boundary/opposed_loops.h"
#include "field/reach.h"
#include "field/source_sampling.h"
#include "mesh/block_loop.h"
#include "mesh/quantile.h"
#include "survey/wanted_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Share of an island's size that makes a hole a source (C4.46-1 says 1): of a limb
 * that was cut through the stump may be the thinner side. */
constexpr double LEAST_HOLE = 0.5;
/** Operations to find the distance across a gap, to place a free point in a tree, and
 * to let free points pull a point of a line. */
constexpr std::uint64_t GAP_WORK = 100;
constexpr std::uint64_t POINT_WORK = 50;
constexpr std::uint64_t LINE_WORK = 500;

/** Loops that are two ends of one gap. Within one island they make a handle: both have
 * to be mouths of tubes for that, or the user wants it. */
std::vector<std::size_t>
facingLoops(const ModelSurvey& survey, ccaa::RunControl* control)
{
  std::vector<std::size_t> opposed = opposedLoops(survey.loops, control);
  for (std::size_t k = 0; k < opposed.size(); ++k) {
    const std::size_t other = opposed[k];
    if (other != NONE && survey.loops[other].island == survey.loops[k].island &&
        !(mayBeStump(survey.classes[k].evidence) &&
          mayBeStump(survey.classes[other].evidence)))
      opposed[k] = NONE;
  }
  for (const auto& [first, second] : wantedPairs(survey))
    if (survey.loops[first].island == survey.loops[second].island) {
      opposed[first] = second;
      opposed[second] = first;
    }
  return opposed;
}

/** A limb may have been cut off beside a hole that took the place where it began: then
 * its mouth looks into that hole, which looks elsewhere. See SurveyedBridges::ahead. */
std::vector<std::size_t>
loopsAhead(const ModelSurvey& survey, const std::vector<std::size_t>& opposed)
{
  std::vector<std::size_t> ahead(opposed.size(), NONE);
  if (!isSeenFromAllSides(survey.facing))
    return ahead;
  for (std::size_t k = 0; k < ahead.size(); ++k) {
    if (opposed[k] != NONE || ahead[k] != NONE || !isMouth(survey.classes[k].evidence))
      continue;
    const std::size_t other = loopAhead(survey.loops, k);
    if (other == NONE || opposed[other] != NONE || ahead[other] != NONE ||
        survey.loops[other].island != survey.loops[k].island)
      continue;
    ahead[k] = other;
    ahead[other] = k;
  }
  return ahead;
}

/** Median of the gaps of all sources; 0 when there is one island only. */
double
medianGap(const SourceSet& sources, ccaa::RunControl* control)
{
  const GapFinder gaps(sources);
  std::vector<double> finite;
  for (const SourceCurve& curve : sources.curves) {
    if (!ccaa::spend(control, GAP_WORK * curve.sources.size()))
      return 0.0;
    for (const double gap : gapsAlong(curve, gaps))
      if (std::isfinite(gap))
        finite.push_back(gap);
  }
  return ccaa::medianOf(std::move(finite));
}

/** The island that a loop stands for. Two opposed loops of one island are two sides of
 * a gap, as if each had an island of its own. */
std::size_t
sideOf(std::size_t loop,
       const ModelSurvey& survey,
       const std::vector<std::size_t>& opposed)
{
  const std::size_t island = survey.loops[loop].island;
  if (opposed[loop] == NONE || survey.loops[opposed[loop]].island != island)
    return island;
  return survey.model.islands.size() + loop;
}

} // namespace

Reach
reachOf(const FieldParameters& parameters)
{
  return {
      parameters.near, parameters.far, parameters.room, parameters.falloff_exponent};
}

BoundaryEdges
targetsOf(const SourceSet& sources, const BoundaryLoops& loops)
{
  std::vector<TargetCurve> targets;
  for (const SourceCurve& curve : sources.curves)
    targets.push_back({loops[curve.loop].curve, curve.island});
  return BoundaryEdges(std::move(targets));
}

IndicatorField
makeField(const SourceSet& sources,
          const FieldParameters& parameters,
          const SurveyGuides& guides)
{
  const bool full = parameters.mode == FieldMode::FULL;
  return IndicatorField(sources,
                        parameters.interpolation,
                        full ? guides.free_points.get() : nullptr,
                        full ? guides.surface.get() : nullptr,
                        parameters.coarse_distance);
}

std::vector<ForceLine>
traceLines(const LineField& place,
           const std::vector<LineOrigin>& origins,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context)
{
  const ForceLineTracker tracker(
      place.field, place.targets, parameters.tracker, place.guides.surface.get());
  std::vector<ForceLine> lines = tracker.track(origins, context);
  PerturbationParameters perturbation = parameters.perturbation;
  perturbation.trust = parameters.field.trust; // k_t is one number (4.424, 4.6)
  const auto shape = [&](ForceLine& line, double spacing) {
    line = resampled(line, spacing);
    if (line.end == LineEnd::BRIDGE && place.guides.free_points)
      line = perturbed(line, *place.guides.free_points, perturbation);
  };
  ccaa::RunControl silent(context.control); // tells no stages
  const ccaa::LoopContext line_by_line{context.threads, &silent, "", 1};
  ccaa::forEachBlock(
      lines.size(), line_by_line, [&](std::size_t i, std::size_t, std::size_t) {
        if (silent.spend(LINE_WORK * (lines[i].points.size() + 1)))
          shape(lines[i], origins[i].query.falloff.near);
      });
  return lines;
}

IslandSources
islandSources(const ModelSurvey& survey,
              const FieldParameters& parameters,
              const ccaa::LoopContext& context)
{
  std::vector<std::size_t> opposed = facingLoops(survey, context.control);
  IslandSources islands;
  islands.ahead = loopsAhead(survey, opposed);
  for (std::size_t k = 0; k < opposed.size(); ++k)
    opposed[k] = islands.ahead[k] == NONE ? opposed[k] : islands.ahead[k];
  std::vector<bool> is_hole;
  std::vector<SourceCurve> curves;
  for (std::size_t k = 0; k < survey.loops.size(); ++k) {
    is_hole.push_back(survey.classes[k].boundary_class == BoundaryClass::HOLE &&
                      opposed[k] == NONE && !mayBeStump(survey.classes[k].evidence));
    if (survey.model.islands[survey.loops[k].island].is_fin)
      continue;
    curves.push_back(sampleSources(survey.loops[k].curve, parameters.near));
    curves.back().island = sideOf(k, survey, opposed);
    curves.back().loop = k;
  }
  SourceSet all = gatherSources(std::move(curves));
  islands.median_gap = medianGap(all, context.control);
  const double reach =
      parameters.far > 0.0 ? parameters.far : parameters.room * islands.median_gap;
  const std::vector<bool> are_sources =
      areIslandSources(survey.loops, is_hole, reach, LEAST_HOLE);
  all.curves.erase(std::remove_if(all.curves.begin(),
                                  all.curves.end(),
                                  [&](const SourceCurve& curve) {
                                    return !are_sources[curve.loop];
                                  }),
                   all.curves.end());
  islands.sources = gatherSources(std::move(all.curves));
  return islands;
}

std::shared_ptr<const SurveyGuides>
makeGuides(const ModelSurvey& survey,
           const FieldParameters& parameters,
           double median_gap,
           bool with_surface,
           const ccaa::LoopContext& context)
{
  auto guides = std::make_shared<SurveyGuides>();
  if (with_surface)
    guides->surface =
        std::make_unique<Shield>(survey.model, context.threads, context.control);
  const Positions& points = survey.model.free_points;
  if (points.empty() || !(parameters.trust > 0.0))
    return guides;
  ccaa::spend(context.control, POINT_WORK * points.size());
  const double spacing = parameters.free_point_near > 0.0 ? parameters.free_point_near
                                                          : meanSpacing(points);
  Falloff falloff =
      freePointFalloff(spacing, median_gap, parameters.free_point_exponent);
  if (parameters.free_point_far > 0.0)
    falloff.far = parameters.free_point_far;
  ccaa::spend(context.control, POINT_WORK * points.size());
  guides->free_points = std::make_unique<FreePointField>(
      points, falloff, parameters.trust, parameters.search);
  return guides;
}

SurveyedField
surveyHole(const ModelSurvey& survey,
           std::size_t loop,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context)
{
  const SurveyGuides& guides = *survey.guides;
  SurveyedField surveyed;
  surveyed.hole = loop;
  SourceCurve curve = sampleSources(survey.loops[loop].curve, parameters.field.near);
  curve.island = survey.loops[loop].island;
  curve.loop = loop;
  const SourceSet sources = gatherSources({std::move(curve)});
  const BoundaryEdges targets = targetsOf(sources, survey.loops);
  const IndicatorField field = makeField(sources, parameters.field, guides);
  const double threshold = parameters.hole_threshold * survey.loops[loop].length;
  surveyed.origins =
      originsInHole(field, targets, 0, threshold, reachOf(parameters.field), context);
  std::vector<LineOrigin> origins;
  for (const std::size_t i :
       strongestOrigins(surveyed.origins, targets, parameters.line_spacing))
    origins.push_back(surveyed.origins[i].origin);
  surveyed.lines = traceLines({field, targets, guides}, origins, parameters, context);
  return surveyed;
}

} // namespace pcl::repair
