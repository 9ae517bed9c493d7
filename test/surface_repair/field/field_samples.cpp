// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sources and surroundings with known facts, for tests of the
// field.
#include "field_samples.h"

#include "field/source_sampling.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair::test {
namespace {

/** \brief sigma by h (E4.5-1), 0 within arc T of the origin; 1 without 4.5. */
double
chargeShare(const FieldQuery& query,
            const SourceCurve& curve,
            const FieldSource& source)
{
  if (!query.effective)
    return 1.0;
  const double way = std::abs(source.arc - query.effective->arc);
  if (std::min(way, curve.length - way) <= query.effective->threshold)
    return 0.0;
  return -query.effective->tangent.dot(source.tangent);
}

/** \brief E4.43-3 of one source, without its charge. */
Tension
plainTension(const FieldSource& source, const Position& x, double q_12, double k_i)
{
  const Direction d = (source.position - x).normalized();
  const Eigen::Vector3d s = -d.cross(source.tangent);             // E4.427-4
  const double q_4 = (1.0 + s.dot(source.normal)) / 2.0;          // E4.426-1
  const Tension a = q_12 * (1.0 + k_i * q_4) * d * s.transpose(); // E4.43-4
  const Tension b = Tension::Identity() - d * d.transpose();      // E4.43-5
  return a * b;
}

} // namespace

BoundaryCurve
ring(int edges, double radius, double height, bool surface_above)
{
  BoundaryCurve curve;
  const double turn = (surface_above ? 2.0 : -2.0) * M_PI / edges;
  for (int k = 0; k < edges; ++k) {
    const double angle = turn * k, middle = turn * (k + 0.5);
    curve.points.emplace_back(
        radius * std::cos(angle), radius * std::sin(angle), height);
    curve.normals.emplace_back(std::cos(middle), std::sin(middle), 0.0);
  }
  return curve;
}

SourceSet
twoCaps(int edges, double gap)
{
  const double height = 0.5 * gap, radius = std::sqrt(1.0 - height * height);
  std::vector<SourceCurve> curves = {
      sampleSources(ring(edges, radius, height, true)),
      sampleSources(ring(edges, radius, -height, false))};
  curves[0].island = 0;
  curves[1].island = 1;
  return gatherSources(std::move(curves));
}

Position
randomPosition(RandomSource& random)
{
  return {random.uniform(), random.uniform(), random.uniform()};
}

Direction
randomDirection(RandomSource& random)
{
  return Direction(random.normal(), random.normal(), random.normal()).normalized();
}

SourceSet
randomSources(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  SourceSet set;
  set.spacing = 0.01;
  set.curves.resize(3);
  for (std::size_t i = 0; i < count; ++i) {
    SourceCurve& curve = set.curves[3 * i / count];
    curve.island = 3 * i / count;
    FieldSource source;
    source.position = randomPosition(random);
    source.tangent = randomDirection(random);
    source.normal = source.tangent.cross(randomDirection(random)).normalized();
    source.charge = random.uniform(-2.0, 2.0);
    source.arc = curve.length;
    curve.length += 0.01;
    curve.sources.push_back(source);
  }
  return set;
}

std::vector<FieldQuery>
randomQueries(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<FieldQuery> queries(count);
  for (FieldQuery& query : queries) {
    query.position = randomPosition(random);
    query.falloff = {0.05, 0.8, 2.5};
  }
  return queries;
}

Tension
plainTension(const SourceSet& sources,
             const FieldQuery& query,
             double interpolation,
             const FreePointField* free_points,
             const Shield* shield)
{
  Tension sum = Tension::Zero();
  const Position& x = query.position;
  for (std::size_t i = 0; i < sources.curves.size(); ++i) {
    const SourceCurve& curve = sources.curves[i];
    if ((query.silent_island != NONE && curve.island == query.silent_island) ||
        (query.effective && query.effective->curve != i))
      continue;
    for (const FieldSource& source : curve.sources) {
      const Position& o = source.position;
      const double length = (o - x).norm();
      if (length >= query.falloff.far || length <= 1e-12 * query.falloff.far ||
          (shield != nullptr && shield->crosses(x, o, sources.spacing)))
        continue;
      const double ratio =
          free_points == nullptr ? 1.0 : free_points->lengthRatio(x, o);
      sum += source.charge * chargeShare(query, curve, source) *
             plainTension(source, x, query.falloff(ratio * length), interpolation);
    }
  }
  return sum;
}

double
weightAt(const SourceSet& sources, const FieldQuery& query)
{
  double sum = 0.0;
  for (const SourceCurve& curve : sources.curves)
    for (const FieldSource& source : curve.sources)
      sum += std::abs(source.charge) *
             query.falloff((source.position - query.position).norm());
  return sum;
}

IncompleteModel
modelOf(const ccaa::test::Shape& shape)
{
  IncompleteModel model;
  model.positions = shape.vertices;
  model.triangles = shape.triangles;
  return model;
}

} // namespace pcl::repair::test
