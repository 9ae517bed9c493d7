// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how fast the indicator field is, and what full mode costs.
#include "field_speed.h"

#include "field/free_point_field.h"
#include "field/indicator_field.h"
#include "field/reach.h"
#include "field/shielding.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

namespace bench {
namespace {

using namespace pcl::repair;

/** \brief Steps out from each source, so many to a gap. */
constexpr int STEPS = 4;

/** \brief Processor seconds, the least of several runs: other work on the machine does
 * not count. */
double
leastSecondsOf(int repeats, const std::function<void()>& work)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

/** \brief Places along the conormals of all sources, as a tracker visits them: all
 * sources of a curve step by step. */
std::vector<FieldQuery>
queriesFor(const FieldCase& field_case, const LightSpeed& row)
{
  std::vector<FieldQuery> queries;
  for (std::size_t i = 0; i < field_case.sources.curves.size(); ++i) {
    const SourceCurve& curve = field_case.sources.curves[i];
    for (int step = 0; step < STEPS; ++step)
      for (const FieldSource& source : curve.sources) {
        FieldQuery query;
        query.position = source.position + step * field_case.gap / STEPS *
                                               source.tangent.cross(source.normal);
        query.falloff = {field_case.sources.spacing, field_case.reach, row.exponent};
        if (row.effective)
          query.effective = EffectiveCharge{source.tangent, source.arc, 0.0, i};
        else
          query.silent_island = curve.island;
        queries.push_back(query);
      }
  }
  return queries;
}

double
countPairs(const SourceSet& sources, const std::vector<FieldQuery>& queries)
{
  std::size_t pairs = 0;
  for (const FieldQuery& query : queries)
    for (std::size_t i = 0; i < sources.curves.size(); ++i) {
      const SourceCurve& curve = sources.curves[i];
      const bool counts = query.effective ? query.effective->curve == i
                                          : curve.island != query.silent_island;
      const double squared = query.falloff.far * query.falloff.far;
      if (counts)
        for (const FieldSource& source : curve.sources)
          pairs += (source.position - query.position).squaredNorm() < squared;
    }
  return static_cast<double>(pairs);
}

void
measureLight(const FieldCase& field_case, int repeats, LightSpeed& row)
{
  const std::vector<FieldQuery> queries = queriesFor(field_case, row);
  const IndicatorField field(field_case.sources, row.interpolation);
  const double pairs = countPairs(field_case.sources, queries);
  row.pairs_per_query = pairs / static_cast<double>(queries.size());
  row.pairs_per_second =
      pairs / leastSecondsOf(repeats, [&] { field.tensionAt(queries, {}); });
}

/** \brief The sum of all weights, and the tension with every source looked at for
 * itself (E4.43-6). */
struct PlainField {
  double weights = 0.0;
  Tension tension = Tension::Zero();

  PlainField(const SourceSet& sources,
             const FieldQuery& query,
             const FreePointField& points,
             const Shield& shield)
  {
    for (const SourceCurve& curve : sources.curves)
      if (curve.island != query.silent_island)
        for (const FieldSource& source : curve.sources)
          add(source,
              query,
              points,
              shield.crosses(query.position, source.position, sources.spacing));
  }

private:
  void
  add(const FieldSource& source,
      const FieldQuery& query,
      const FreePointField& points,
      bool shielded)
  {
    const Eigen::Vector3d way = source.position - query.position;
    const double length = way.norm();
    if (!(length < query.falloff.far) || length == 0.0)
      return;
    const double ratio = points.lengthRatio(query.position, source.position);
    const double weight = source.charge * query.falloff(ratio * length);
    const Eigen::Vector3d d = way / length;
    weights += weight;
    if (!shielded)
      tension -= weight * d * d.cross(source.tangent).transpose();
  }
};

/** \brief Error of full mode at every so many-th query. */
double
errorOf(const IndicatorField& field,
        const std::vector<FieldQuery>& queries,
        const FreePointField& points,
        const Shield& shield)
{
  constexpr std::size_t STRIDE = 23;
  double error = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < queries.size(); i += STRIDE) {
    const PlainField plain(field.sources(), queries[i], points, shield);
    error += (field.tensionAt(queries[i]) - plain.tension).norm();
    weights += plain.weights;
  }
  return weights > 0.0 ? error / weights : 0.0;
}

} // namespace

std::vector<LightSpeed>
measureLightField(const FieldCase& field_case, int repeats)
{
  std::vector<LightSpeed> rows;
  for (const double exponent : {1.0, 1.7, 2.0, 2.5})
    rows.push_back({exponent, 0.0, false, 0.0, 0.0});
  rows.push_back({2.5, 1.0, false, 0.0, 0.0});
  rows.push_back({2.5, 0.0, true, 0.0, 0.0});
  for (LightSpeed& row : rows)
    measureLight(field_case, repeats, row);
  return rows;
}

FullSpeed
measureFullField(const FieldCase& field_case, int repeats)
{
  FullSpeed speed;
  const SourceSet& sources = field_case.sources;
  const std::clock_t start = std::clock();
  const FreePointField points(
      field_case.model.free_points,
      freePointFalloff(meanSpacing(field_case.model.free_points), field_case.gap),
      DEFAULT_TRUST);
  const Shield shield(field_case.model);
  speed.build = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const std::vector<FieldQuery> queries = queriesFor(field_case, {});
  const auto microseconds = [&](const FreePointField* p, const Shield* s) {
    const IndicatorField field(sources, 0.0, p, s);
    return 1e6 / static_cast<double>(queries.size()) *
           leastSecondsOf(repeats, [&] { field.tensionAt(queries, {}); });
  };
  speed.light = microseconds(nullptr, nullptr);
  speed.free_points = microseconds(&points, nullptr);
  speed.shield = microseconds(nullptr, &shield);
  speed.full = microseconds(&points, &shield);
  speed.error =
      errorOf(IndicatorField(sources, 0.0, &points, &shield), queries, points, shield);
  return speed;
}

void
printLightField(const FieldCase& field_case, const std::vector<LightSpeed>& rows)
{
  std::printf("Field, light mode, %s: %zu sources, one thread\n\n"
              "| chi | k_i | charges | sources in L2 | pairs/s |\n"
              "|---|---|---|---|---|\n",
              field_case.name.c_str(),
              field_case.sources.size());
  for (const LightSpeed& row : rows)
    std::printf("| %.1f | %.1f | %s | %.0f | %.0f M |\n",
                row.exponent,
                row.interpolation,
                row.effective ? "effective" : "plain",
                row.pairs_per_query,
                1e-6 * row.pairs_per_second);
}

void
printFullField(const FieldCase& field_case, const FullSpeed& speed)
{
  std::printf(
      "\nField, full mode, %s: %zu triangles, %zu free points; built in %.0f ms\n"
      "\n| us/query | light | free points | shield | both | both / light | error |\n"
      "|---|---|---|---|---|---|---|\n"
      "| | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f %% |\n",
      field_case.name.c_str(),
      field_case.model.triangles.size(),
      field_case.model.free_points.size(),
      speed.build,
      speed.light,
      speed.free_points,
      speed.shield,
      speed.full,
      speed.ratio(),
      100.0 * speed.error);
}

} // namespace bench
