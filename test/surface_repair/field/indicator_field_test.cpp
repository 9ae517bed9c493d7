// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the indicator field in light mode (4.43).
#include <gtest/gtest.h>

#include "field/indicator_field.h"
#include "field_samples.h"

namespace pcl::repair::test {
namespace {

void
expectPlain(const SourceSet& sources,
            const std::vector<FieldQuery>& queries,
            double interpolation)
{
  const IndicatorField field(sources, interpolation);
  for (const FieldQuery& query : queries)
    EXPECT_LT((field.tensionAt(query) - plainTension(sources, query, interpolation))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12 * weightAt(sources, query) + 1e-15);
}

TEST(IndicatorField, IsTheSumOfTheThesisForAnyExponent)
{
  const SourceSet sources = randomSources(500, 1);
  for (const double exponent : {0.3, 0.5, 1.0, 1.5, 1.7, 2.0, 2.5, 3.0, 4.25, 9.5}) {
    std::vector<FieldQuery> queries = randomQueries(20, 2);
    for (FieldQuery& query : queries)
      query.falloff.exponent = exponent;
    expectPlain(sources, queries, 0.0);
  }
}

TEST(IndicatorField, IsTheSumOfTheThesisWithInterpolation)
{
  expectPlain(randomSources(500, 3), randomQueries(50, 4), 0.7);
}

TEST(IndicatorField, MissesNoSourceOfALargeSet)
{
  SourceSet sources = twoCaps(6000, 0.02);
  const Eigen::Vector3d shift(1e4, -2e4, 3e4);
  for (SourceCurve& curve : sources.curves)
    for (FieldSource& source : curve.sources)
      source.position += shift;
  std::vector<FieldQuery> queries(40);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double angle = 0.1 * static_cast<double>(i);
    queries[i].position = shift + Position(std::cos(angle), std::sin(angle), 0.004);
    queries[i].falloff = {0.001, 0.02 * static_cast<double>(1 + i % 8), 2.5};
  }
  expectPlain(sources, queries, 0.0);
}

TEST(IndicatorField, LeavesOutTheSilentIsland)
{
  std::vector<FieldQuery> queries = randomQueries(50, 5);
  for (std::size_t i = 0; i < queries.size(); ++i)
    queries[i].silent_island = i % 4;
  expectPlain(randomSources(300, 6), queries, 0.0);
}

TEST(IndicatorField, TakesEffectiveChargesOfOneCurve) // 4.5
{
  RandomSource random(7);
  std::vector<FieldQuery> queries = randomQueries(60, 8);
  for (std::size_t i = 0; i < queries.size(); ++i)
    queries[i].effective =
        EffectiveCharge{randomDirection(random), random.uniform(0.0, 1.0), 0.1, i % 3};
  expectPlain(randomSources(300, 9), queries, 0.3);
}

TEST(IndicatorField, OfASetIsTheSumOfItsParts) // E4.43-2
{
  const SourceSet all = randomSources(300, 10);
  for (const FieldQuery& query : randomQueries(30, 11)) {
    Tension sum = Tension::Zero();
    for (const SourceCurve& curve : all.curves)
      sum += IndicatorField(SourceSet{{curve}, all.spacing}).tensionAt(query);
    EXPECT_LT((sum - IndicatorField(all).tensionAt(query)).norm(),
              1e-12 * weightAt(all, query) + 1e-15);
  }
}

TEST(IndicatorField, IsLinearInTheCharge) // E4.43-2d
{
  const SourceSet sources = randomSources(300, 12);
  SourceSet charged = sources;
  for (SourceCurve& curve : charged.curves)
    for (FieldSource& source : curve.sources)
      source.charge *= -4.0;
  const IndicatorField field(sources), other(charged);
  for (const FieldQuery& query : randomQueries(30, 13))
    EXPECT_EQ(other.tensionAt(query), Tension(-4.0 * field.tensionAt(query)));
}

TEST(IndicatorField, GivesTheForceOfTheQualityIndex) // E4.427-8, E4.43-1
{
  SourceSet sources = randomSources(3, 14);
  sources.curves.resize(1);
  const FieldSource& source = sources.curves[0].sources[0];
  const IndicatorField field(sources, 0.5);
  RandomSource random(15);
  for (FieldQuery& query : randomQueries(50, 16)) {
    query.falloff.far = 2.0;
    const Direction n = randomDirection(random);
    const Eigen::Vector3d way = source.position - query.position;
    const Direction d = way.normalized();
    const Eigen::Vector3d s = -d.cross(source.tangent);
    const double q_4 = (1.0 + s.dot(source.normal)) / 2.0;
    const double quality =
        (n - d * n.dot(d)).dot(s) * query.falloff(way.norm()) * (1.0 + 0.5 * q_4);
    const Eigen::Vector3d force = source.charge * d * quality;
    EXPECT_LT((field.tensionAt(query) * n - force).norm(), 1e-12);
  }
}

TEST(IndicatorField, PullsAcrossTheGapWithTheNormalOutwards)
{
  const IndicatorField field(twoCaps(200, 0.3));
  FieldQuery query;
  query.position = {1.0, 0.0, 0.1};
  query.falloff = {0.03, 0.75, 2.5};
  query.silent_island = 0;
  const Eigen::Vector3d force = field.tensionAt(query) * Direction::UnitX();
  EXPECT_LT(force.z(), -1.0);
  EXPECT_NEAR(force.y(), 0.0, 1e-9);
}

TEST(IndicatorField, DoesNotCountASourceAtThePointItself)
{
  SourceSet sources = randomSources(100, 17);
  FieldQuery query = randomQueries(1, 18).front();
  query.position = sources.curves[1].sources[5].position;
  const Tension with = IndicatorField(sources).tensionAt(query);
  sources.curves[1].sources[5].charge = 0.0;
  EXPECT_EQ(with, IndicatorField(sources).tensionAt(query));
}

/** \brief Places in the gap of two caps, each with its own island silent. */
std::vector<FieldQuery>
queriesInGap(double far)
{
  std::vector<FieldQuery> queries(60);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double angle = 0.1 * static_cast<double>(i);
    queries[i].position = Position(std::cos(angle), std::sin(angle), 0.1);
    queries[i].falloff = {0.01, far, 2.5};
    queries[i].silent_island = 0;
  }
  return queries;
}

TEST(IndicatorField, WithCoarseSourcesIsNearlyTheSame)
{
  const SourceSet sources = twoCaps(3000, 0.3);
  const IndicatorField fine(sources, 0.5);
  const IndicatorField coarse(sources, 0.5, nullptr, nullptr, 8.0);
  bool any_differs = false;
  for (const FieldQuery& query : queriesInGap(2.0)) {
    const Tension exact = fine.tensionAt(query);
    const Tension near = coarse.tensionAt(query);
    EXPECT_LT((near - exact).norm(), 2e-3 * exact.norm());
    any_differs = any_differs || near != exact;
  }
  EXPECT_TRUE(any_differs);
}

/** With all sources of the other cap coarse. */
double
errorOfCoarseSources(int edges)
{
  const SourceSet sources = twoCaps(edges, 0.3);
  const IndicatorField fine(sources);
  const IndicatorField coarse(sources, 0.0, nullptr, nullptr, 4.0);
  double error = 0.0;
  for (const FieldQuery& query : queriesInGap(2.0)) {
    const Tension exact = fine.tensionAt(query);
    error = std::max(error, (coarse.tensionAt(query) - exact).norm() / exact.norm());
  }
  return error;
}

TEST(IndicatorField, WithCoarseSourcesErrsByTheSquareOfTheirSize)
{
  EXPECT_NEAR(errorOfCoarseSources(1536) / errorOfCoarseSources(3072), 4.0, 0.5);
}

TEST(IndicatorField, WithCoarseSourcesIsTheSameWhereNothingIsFar)
{
  const SourceSet sources = twoCaps(100, 0.3);
  const IndicatorField fine(sources);
  const IndicatorField coarse(sources, 0.0, nullptr, nullptr, 8.0);
  for (const FieldQuery& query : queriesInGap(0.5))
    EXPECT_EQ(fine.tensionAt(query), coarse.tensionAt(query));
}

TEST(IndicatorField, WithCoarseSourcesAloneIsAsInABatch)
{
  const IndicatorField field(twoCaps(3000, 0.3), 0.0, nullptr, nullptr, 8.0);
  const std::vector<FieldQuery> queries = queriesInGap(2.0);
  const std::vector<Tension> together = field.tensionAt(queries, {});
  for (std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_EQ(field.tensionAt(queries[i]), together[i]);
}

TEST(IndicatorField, IsZeroOutOfReach)
{
  const IndicatorField field(randomSources(100, 19));
  FieldQuery query = randomQueries(1, 20).front();
  query.position = {1e6, -1e6, 5.0};
  EXPECT_TRUE(field.tensionAt(query).isZero(0.0));
}

TEST(IndicatorField, IsZeroWithoutSourcesReachOrPlace)
{
  FieldQuery query = randomQueries(1, 21).front();
  EXPECT_TRUE(IndicatorField(SourceSet()).tensionAt(query).isZero(0.0));
  const IndicatorField field(randomSources(100, 22));
  query.falloff.far = 0.0;
  EXPECT_TRUE(field.tensionAt(query).isZero(0.0));
  query.falloff.far = 1.0;
  query.position.x() = std::nan("");
  EXPECT_TRUE(field.tensionAt(query).isZero(0.0));
}

TEST(IndicatorField, CountsAllAlikeWithinAStep)
{
  std::vector<FieldQuery> queries = randomQueries(30, 23);
  for (FieldQuery& query : queries)
    query.falloff = {0.5, 0.5, 2.5};
  expectPlain(randomSources(200, 24), queries, 0.0);
}

} // namespace
} // namespace pcl::repair::test
