// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the indicator field in full mode (E4.424-2,
// E4.43-6).
#include <gtest/gtest.h>

#include "field/indicator_field.h"
#include "field_samples.h"

namespace pcl::repair::test {
namespace {

std::vector<FieldQuery>
queriesInGap(std::size_t count)
{
  RandomSource random(1);
  std::vector<FieldQuery> queries(count);
  for (FieldQuery& query : queries) {
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    query.position = {std::cos(angle), std::sin(angle), random.uniform(-0.12, 0.12)};
    query.falloff = {0.03, 0.75, 2.5};
  }
  return queries;
}

/** \brief Free points scattered over half of the gap of twoCaps(). */
Positions
pointsInGap()
{
  RandomSource random(2);
  Positions points(60);
  for (Position& point : points) {
    const double angle = random.uniform(0.0, M_PI);
    point = {std::cos(angle), std::sin(angle), random.uniform(-0.12, 0.12)};
  }
  return points;
}

/** \brief A wall of 2 x 2 at x = 0.9 that hides what is behind it, and touches no
 * boundary of twoCaps(). */
IncompleteModel
wall()
{
  ccaa::test::Shape shape = ccaa::test::grid(9, 9);
  for (Position& vertex : shape.vertices)
    vertex = Position(0.9, 0.25 * vertex.x() - 1.0, 0.25 * vertex.y() - 1.0);
  return modelOf(shape);
}

TEST(IndicatorFieldFull, IsTheLightFieldBitForBitWhenNothingIsAround)
{
  const SourceSet sources = twoCaps(200, 0.3);
  const FreePointField no_points({}, {0.05, 0.2, 1.0}, 0.5);
  const Shield no_surface{IncompleteModel()};
  const IndicatorField light(sources, 0.5);
  const IndicatorField full(sources, 0.5, &no_points, &no_surface);
  for (const FieldQuery& query : queriesInGap(100))
    EXPECT_EQ(full.tensionAt(query), light.tensionAt(query));
}

/** \brief Error of the field against every source looked at for itself, by the sum of
 * weights in light mode: over all queries, and the worst. */
struct FieldError {
  double overall = 0.0, worst = 0.0;
};

FieldError
errorOf(const FreePointField* points, const Shield* shield)
{
  const SourceSet sources = twoCaps(200, 0.3);
  const IndicatorField field(sources, 0.0, points, shield);
  FieldError error;
  double sum = 0.0, weights = 0.0;
  for (const FieldQuery& query : queriesInGap(150)) {
    const double difference =
        (field.tensionAt(query) - plainTension(sources, query, 0.0, points, shield))
            .norm();
    const double weight = weightAt(sources, query);
    error.worst = std::max(error.worst, difference / weight);
    sum += difference;
    weights += weight;
  }
  error.overall = sum / weights;
  return error;
}

TEST(IndicatorFieldFull, ShortensAsEverySourceForItselfWithinAFewPercent)
{
  const FreePointField points(pointsInGap(), {0.1, 0.15, 1.0}, 0.5);
  const FieldError error = errorOf(&points, nullptr);
  EXPECT_LT(error.overall, 0.07);
  EXPECT_LT(error.worst, 0.25);
}

TEST(IndicatorFieldFull, ShieldsAsEverySourceForItselfWithinAFewPercent)
{
  const Shield shield(wall());
  const FieldError error = errorOf(nullptr, &shield);
  EXPECT_LT(error.overall, 0.02);
  EXPECT_LT(error.worst, 0.2);
}

TEST(IndicatorFieldFull, DoesBothAtOnce)
{
  const FreePointField points(pointsInGap(), {0.1, 0.15, 1.0}, 0.5);
  const Shield shield(wall());
  EXPECT_LT(errorOf(&points, &shield).overall, 0.1);
}

TEST(IndicatorFieldFull, IsStrongerWhereFreePointsAre)
{
  const SourceSet sources = twoCaps(200, 0.3);
  const FreePointField points(pointsInGap(), {0.1, 0.15, 1.0}, 0.5);
  const IndicatorField light(sources), full(sources, 0.0, &points);
  FieldQuery query = queriesInGap(1).front();
  query.position = {0.0, 1.0, 0.0};
  EXPECT_GT(full.tensionAt(query).norm(), 1.2 * light.tensionAt(query).norm());
  query.position = {0.0, -1.0, 0.0};
  EXPECT_EQ(full.tensionAt(query), light.tensionAt(query));
}

TEST(IndicatorFieldFull, IsNothingBehindAClosedSurface)
{
  const Shield shield(modelOf(ccaa::test::icosphere(3, 0.5)));
  const IndicatorField field(twoCaps(200, 0.3), 0.0, nullptr, &shield);
  FieldQuery query = queriesInGap(1).front();
  query.position = Position(0.05, 0.02, 0.01);
  query.falloff.far = 2.0;
  EXPECT_TRUE(field.tensionAt(query).isZero(0.0));
}

TEST(IndicatorFieldFull, DoesNotBringInWhatIsBeyondReach)
{
  const FreePointField points(pointsInGap(), {0.5, 0.8, 1.0}, 0.9);
  const SourceSet sources = twoCaps(200, 0.3);
  const IndicatorField field(sources, 0.0, &points);
  FieldQuery query = queriesInGap(1).front();
  query.position = {0.0, 1.0, 0.0};
  query.falloff.far = 0.14; // the boundaries are 0.15 away
  EXPECT_TRUE(field.tensionAt(query).isZero(0.0));
}

TEST(IndicatorFieldFull, GivesTheSameBitsSinglyInBatchesAndOnThreads)
{
  const FreePointField points(pointsInGap(), {0.1, 0.15, 1.0}, 0.5);
  const Shield shield(wall());
  const IndicatorField field(twoCaps(200, 0.3), 0.5, &points, &shield);
  const std::vector<FieldQuery> queries = queriesInGap(600);
  ccaa::LoopContext context;
  context.threads = 3;
  const std::vector<Tension> tensions = field.tensionAt(queries, context);
  EXPECT_EQ(tensions, field.tensionAt(queries, {}));
  for (std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_EQ(tensions[i], field.tensionAt(queries[i]));
}

} // namespace
} // namespace pcl::repair::test
