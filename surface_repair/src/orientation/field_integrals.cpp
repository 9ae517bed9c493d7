// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the islands' boundaries attract each other (E4.48-1).

#include "orientation/field_integrals.h"

#include "field/indicator_field.h"
#include "field/reach.h"
#include "field/source_sampling.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::repair {

namespace {

/** chi of the field at this step: the thesis' value for its cases. */
constexpr double CHI = 2.5;

/** Sources to a gap that a field needs to see how its two sides lie to each other. */
constexpr double SOURCES_PER_GAP = 2.0;

/** Finest sampling, in sources to a mean edge. */
constexpr double MOST_PER_EDGE = 8.0;

/** A gap where there is no other boundary. */
constexpr double FAR = std::numeric_limits<double>::infinity();

SourceCurve
sample(const BoundaryLoops& loops, std::size_t loop, double spacing)
{
  SourceCurve curve = sampleSources(loops[loop].curve, spacing);
  curve.island = loops[loop].island;
  curve.loop = loop;
  return curve;
}

/** Sources one edge apart, closer where the gap to the next island is narrower than
 * that: a boundary's force on a point nearer than its sources has no direction. */
SourceSet
sourcesFor(const BoundaryLoops& loops)
{
  std::vector<SourceCurve> curves;
  for (std::size_t k = 0; k < loops.size(); ++k)
    curves.push_back(sample(loops, k, 0.0));
  const SourceSet coarse = gatherSources(curves);
  const GapFinder gaps(coarse);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const double wanted =
        ccaa::quantile(gapsAlong(coarse.curves[k], gaps), 0.25, FAR) / SOURCES_PER_GAP;
    if (wanted < coarse.curves[k].spacing)
      curves[k] =
          sample(loops, k, std::max(wanted, coarse.curves[k].spacing / MOST_PER_EDGE));
  }
  return gatherSources(std::move(curves));
}

/** The sources of each island as a field of its own. */
struct IslandField {
  std::size_t island = NONE;
  Eigen::AlignedBox3d box;
  std::unique_ptr<IndicatorField> field;
};

std::vector<IslandField>
fieldPerIsland(const SourceSet& sources)
{
  std::map<std::size_t, SourceSet> of_island;
  for (const SourceCurve& curve : sources.curves)
    of_island[curve.island].curves.push_back(curve);
  std::vector<IslandField> fields;
  for (auto& [island, set] : of_island) {
    set.spacing = sources.spacing; // charges are those of the whole set
    IslandField field;
    field.island = island;
    for (const SourceCurve& curve : set.curves)
      for (const FieldSource& source : curve.sources)
        field.box.extend(source.position);
    field.field = std::make_unique<IndicatorField>(set);
    fields.push_back(std::move(field));
  }
  return fields;
}

/** The places of one island where the field is asked, and how far each looks. */
struct BaseQueries {
  std::vector<FieldQuery> queries;
  std::vector<const FieldSource*> places;
  std::vector<double> facing; /**< see facingOf() */
};

/** How much a place faces the nearest other island: the cosine between its conormal and
 * the way there, 0 if that leads back over its own island. Found from how the gap
 * changes ahead. The conormal does not depend on the winding, so this takes no side;
 * but the far rim of a strip would speak almost as loud as the near one, with the other
 * sign. */
double
facingOf(const FieldSource& source,
         double gap,
         std::size_t island,
         const GapFinder& gaps)
{
  const double step = 0.1 * gap;
  const Direction conormal = source.tangent.cross(source.normal);
  const double ahead = gaps.gapAt(source.position + step * conormal, island);
  return step > 0.0 ? std::clamp((gap - ahead) / step, 0.0, 1.0) : 0.0;
}

/** Each place looks over its gap, but not over more than twice the island's narrow
 * gaps: what is far behind another part of the boundary, or beyond the island, would
 * speak with the wrong sign, and louder the further it looks. */
BaseQueries
queriesOf(std::size_t island,
          const SourceSet& sources,
          const GapFinder& gaps,
          double room)
{
  std::vector<double> all;
  for (const SourceCurve& curve : sources.curves)
    if (curve.island == island)
      for (const double gap : gapsAlong(curve, gaps))
        all.push_back(gap);
  const double widest = 2.0 * ccaa::quantile(all, 0.1, FAR);

  BaseQueries base;
  std::size_t place = 0;
  for (const SourceCurve& curve : sources.curves) {
    if (curve.island != island)
      continue;
    for (const FieldSource& source : curve.sources) {
      const double true_gap = all[place++];
      const double gap = std::min(true_gap, widest);
      if (!std::isfinite(true_gap))
        continue;
      const double facing = facingOf(source, true_gap, island, gaps);
      if (!(facing > 0.0))
        continue;
      FieldQuery query;
      query.position = source.position;
      query.falloff = sourceFalloff(curve.spacing, gap, CHI, room);
      base.queries.push_back(query);
      base.places.push_back(&source);
      base.facing.push_back(facing);
    }
  }
  return base;
}

/** The places that reach into a box. */
BaseQueries
within(const BaseQueries& base, const Eigen::AlignedBox3d& box)
{
  BaseQueries near;
  for (std::size_t i = 0; i < base.queries.size(); ++i)
    if (box.exteriorDistance(base.queries[i].position) < base.queries[i].falloff.far) {
      near.queries.push_back(base.queries[i]);
      near.places.push_back(base.places[i]);
      near.facing.push_back(base.facing[i]);
    }
  return near;
}

PairIntegral
integrate(const BaseQueries& base, const std::vector<Tension>& tensions)
{
  PairIntegral integral;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const FieldSource& place = *base.places[i];
    const Direction conormal = place.tangent.cross(place.normal);
    const double outward =
        (tensions[i] * place.normal).dot(conormal) * place.charge * base.facing[i];
    integral.attraction += outward;
    integral.magnitude += std::abs(outward);
  }
  return integral;
}

} // namespace

std::vector<PairIntegral>
pairIntegrals(const BoundaryLoops& loops, double room, const ccaa::LoopContext& context)
{
  const SourceSet sources = sourcesFor(loops);
  const GapFinder gaps(sources);
  const std::vector<IslandField> fields = fieldPerIsland(sources);

  ccaa::LoopContext one_each = context;
  one_each.block_size = 1;
  std::vector<std::vector<PairIntegral>> of_base(fields.size());
  ccaa::forEachBlock(
      fields.size(), one_each, [&](std::size_t b, std::size_t, std::size_t) {
        const BaseQueries base = queriesOf(fields[b].island, sources, gaps, room);
        for (const IslandField& other : fields) {
          if (other.island == fields[b].island)
            continue;
          const BaseQueries near = within(base, other.box);
          if (near.queries.empty())
            continue;
          PairIntegral integral =
              integrate(near, other.field->tensionAt(near.queries, {}));
          integral.base = fields[b].island;
          integral.source = other.island;
          of_base[b].push_back(integral);
        }
      });
  return ccaa::joinBlocks(of_base);
}

} // namespace pcl::repair
