// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from which places of the boundaries lines begin
// (4.41, 4.5).

#include "force_line/line_origins.h"

#include "field/reach.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace pcl::repair {

namespace {

/** Spacings around a place in which to look first for what lies across a hole. */
constexpr double FIRST_LOOK = 4.0;
/** Operations to find the distance to what lies across a gap. */
constexpr std::uint64_t ACROSS_WORK = 100;

PossibleOrigin
originAt(const SourceCurve& curve,
         const FieldSource& source,
         std::size_t number,
         const BoundaryEdges& targets)
{
  PossibleOrigin origin;
  origin.origin.point = targets.pointAt(number, source.arc);
  origin.origin.tangent = source.tangent;
  origin.origin.normal = source.normal;
  origin.origin.query.silent_island = curve.island;
  return origin;
}

/** Fill in the forces, and leave out the places that nothing reaches. */
std::vector<PossibleOrigin>
askField(const IndicatorField& field,
         std::vector<PossibleOrigin> origins,
         const ccaa::LoopContext& context)
{
  std::vector<FieldQuery> queries;
  for (PossibleOrigin& origin : origins) {
    origin.origin.query.position = origin.origin.point.position;
    queries.push_back(origin.origin.query);
  }
  const std::vector<Tension> tensions = field.tensionAt(queries, context);
  std::vector<PossibleOrigin> reached;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const LineOrigin& origin = origins[i].origin;
    origins[i].force = forceAtOrigin(origin.tangent, origin.normal, tensions[i]);
    if (!origins[i].force.force.isZero(0.0))
      reached.push_back(std::move(origins[i]));
  }
  return reached;
}

/** |f| made comparable between places that look differently far. The sum over a
 * boundary grows like L_2; the second L_2 lets the shorter of two alike gaps win
 * (C4.422-1), which q_1 does where L_2 is the same for all. */
double
strengthOf(const PossibleOrigin& origin)
{
  const double far = origin.origin.query.falloff.far;
  return origin.force.force.norm() / (far * far);
}

/** Distance from a source to the nearest edge of its curve that is further than the
 * threshold along it; the search begins with the distance of the source before. */
double
gapAcross(const LineOrigin& origin,
          const EffectiveCharge& hole,
          const BoundaryEdges& targets,
          double first_guess)
{
  const Position& place = origin.point.position;
  const double longest = targets.lengthOf(hole.curve);
  for (double within = first_guess;; within *= 2.0) {
    const auto nearest = targets.closestFurtherAlong(
        place, place, within, hole.curve, hole.arc, hole.threshold);
    if (nearest)
      return nearest->distance;
    if (within > longest)
      return std::numeric_limits<double>::infinity();
  }
}

} // namespace

Falloff
falloffOver(double gap, double source_spacing, const Reach& reach)
{
  const double near = reach.near > 0.0 ? reach.near : source_spacing;
  Falloff falloff = sourceFalloff(near, gap, reach.exponent, reach.room);
  if (reach.far > 0.0)
    falloff.far = reach.far;
  return falloff;
}

std::vector<PossibleOrigin>
originsBetweenIslands(const IndicatorField& field,
                      const BoundaryEdges& targets,
                      const Reach& reach,
                      const ccaa::LoopContext& context)
{
  const SourceSet& sources = field.sources();
  const GapFinder gaps(sources);
  std::vector<PossibleOrigin> origins;
  ccaa::WorkCount work(context.control);
  for (std::size_t c = 0; c < sources.curves.size(); ++c)
    for (const FieldSource& source : sources.curves[c].sources) {
      PossibleOrigin origin = originAt(sources.curves[c], source, c, targets);
      origin.gap = gaps.gapAt(source.position, sources.curves[c].island);
      if (!work.add(ACROSS_WORK))
        return {};
      if (!std::isfinite(origin.gap))
        continue;
      origin.origin.query.falloff =
          falloffOver(origin.gap, sources.curves[c].spacing, reach);
      origin.origin.room = reach.room;
      origins.push_back(std::move(origin));
    }
  return askField(field, std::move(origins), context);
}

std::vector<PossibleOrigin>
originsInHole(const IndicatorField& field,
              const BoundaryEdges& targets,
              std::size_t curve,
              double threshold,
              const Reach& reach,
              const ccaa::LoopContext& context)
{
  const SourceCurve& sources = field.sources().curves[curve];
  std::vector<PossibleOrigin> origins;
  double guess = FIRST_LOOK * sources.spacing;
  ccaa::WorkCount work(context.control);
  for (const FieldSource& source : sources.sources) {
    PossibleOrigin origin = originAt(sources, source, curve, targets);
    if (!work.add(ACROSS_WORK))
      return {};
    const EffectiveCharge hole{source.tangent, source.arc, threshold, curve};
    origin.gap = gapAcross(origin.origin, hole, targets, guess);
    if (!std::isfinite(origin.gap))
      continue;
    guess = std::max(origin.gap + sources.spacing, FIRST_LOOK * sources.spacing);
    origin.origin.query.silent_island = NONE;
    origin.origin.query.effective = hole;
    origin.origin.query.falloff = falloffOver(origin.gap, sources.spacing, reach);
    origin.origin.room = reach.room;
    origins.push_back(std::move(origin));
  }
  return askField(field, std::move(origins), context);
}

std::vector<std::size_t>
strongestOrigins(const std::vector<PossibleOrigin>& origins,
                 const BoundaryEdges& targets,
                 double apart)
{
  std::vector<std::size_t> order(origins.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return strengthOf(origins[a]) > strengthOf(origins[b]);
  });
  std::map<std::size_t, std::set<double>> taken; // arcs, by curve
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    if (!(origins[i].force.outward > 0.0))
      continue;
    const BoundaryPoint& point = origins[i].origin.point;
    const double arc = targets.arcAt(point);
    const double length = targets.lengthOf(point.curve);
    const double spacing = origins[i].origin.query.falloff.near;
    const double room = std::max(apart * origins[i].gap, 1.99 * spacing);
    std::set<double>& arcs = taken[point.curve];
    const auto free_around = [&](double place) {
      const auto after = arcs.lower_bound(place - room);
      return after == arcs.end() || *after > place + room;
    };
    if (!free_around(arc) || !free_around(arc - length) || !free_around(arc + length))
      continue;
    arcs.insert(arc);
    chosen.push_back(i);
  }
  return chosen;
}

} // namespace pcl::repair
