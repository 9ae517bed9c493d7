// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what must not change the indicator field.
#include <gtest/gtest.h>

#include "field/indicator_field.h"
#include "field_samples.h"

#include <algorithm>
#include <limits>

namespace pcl::repair::test {
namespace {

/** \brief Queries around the gap of twoCaps(), neighbours side by side. */
std::vector<FieldQuery>
queriesAlongGap(std::size_t count)
{
  std::vector<FieldQuery> queries(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    queries[i].position = {
        std::cos(angle), std::sin(angle), 0.05 * std::sin(7 * angle)};
    queries[i].falloff = {0.02, 0.4 + 0.2 * std::cos(3 * angle), 2.5};
    queries[i].silent_island = i / 50 % 2;
  }
  return queries;
}

TEST(IndicatorFieldBatch, GivesTheBitsOfSinglePoints)
{
  const IndicatorField field(twoCaps(300, 0.3), 0.5);
  const std::vector<FieldQuery> queries = queriesAlongGap(500);
  const std::vector<Tension> tensions = field.tensionAt(queries, {});
  for (std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_EQ(tensions[i], field.tensionAt(queries[i]));
}

TEST(IndicatorFieldBatch, GivesTheBitsOfSinglePointsOfTwoFieldsInTurn)
{
  const IndicatorField first(twoCaps(300, 0.3), 0.5);
  const IndicatorField second(twoCaps(400, 0.2), 0.5);
  const std::vector<FieldQuery> queries = queriesAlongGap(100);
  const std::vector<Tension> of_first = first.tensionAt(queries, {});
  const std::vector<Tension> of_second = second.tensionAt(queries, {});
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_EQ(of_first[i], first.tensionAt(queries[i]));
    EXPECT_EQ(of_second[i], second.tensionAt(queries[i]));
  }
}

TEST(IndicatorFieldBatch, IsTheSameForAnyNumberOfThreads)
{
  const IndicatorField field(twoCaps(300, 0.3));
  const std::vector<FieldQuery> queries = queriesAlongGap(2000);
  const std::vector<Tension> alone = field.tensionAt(queries, {});
  for (const int threads : {2, 3, 8}) {
    ccaa::LoopContext context;
    context.threads = threads;
    EXPECT_EQ(field.tensionAt(queries, context), alone);
  }
}

TEST(IndicatorFieldBatch, DoesNotDependOnTheNeighboursInTheList)
{
  const IndicatorField field(twoCaps(300, 0.3));
  std::vector<FieldQuery> queries = queriesAlongGap(300);
  queries[100].position.y() = std::numeric_limits<double>::infinity();
  queries[200].falloff.far = 0.0;
  queries[250].effective = EffectiveCharge{Direction::UnitZ(), 0.0, 0.1, 1};
  const std::vector<Tension> forwards = field.tensionAt(queries, {});
  std::vector<FieldQuery> reversed(queries.rbegin(), queries.rend());
  std::vector<Tension> backwards = field.tensionAt(reversed, {});
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(forwards, backwards);
}

TEST(IndicatorFieldBatch, StopsWhenCancelled)
{
  const IndicatorField field(twoCaps(100, 0.3));
  ccaa::RunControl control([](const std::string&, double) { return false; });
  control.report("before", 0.0);
  ccaa::LoopContext context;
  context.control = &control;
  for (const Tension& tension : field.tensionAt(queriesAlongGap(100), context))
    EXPECT_TRUE(tension.isZero(0.0));
}

/** \brief Turn, scale and shift sources and queries alike. */
struct Motion {
  Eigen::Matrix3d turn;
  double scale;
  Eigen::Vector3d shift;

  Position
  operator()(const Position& position) const
  {
    return turn * position * scale + shift;
  }
};

void
expectOnlyTheFrameToChange(const Motion& motion, double tolerance)
{
  SourceSet sources = twoCaps(200, 0.3);
  const IndicatorField before(sources, 0.5);
  for (SourceCurve& curve : sources.curves)
    for (FieldSource& source : curve.sources) {
      source.position = motion(source.position);
      source.tangent = motion.turn * source.tangent;
      source.normal = motion.turn * source.normal;
    }
  const IndicatorField after(sources, 0.5);
  for (FieldQuery query : queriesAlongGap(50)) {
    const Tension tension = before.tensionAt(query);
    query.position = motion(query.position);
    query.falloff.near *= motion.scale;
    query.falloff.far *= motion.scale;
    const Tension expected = motion.turn * tension * motion.turn.transpose();
    EXPECT_LT((after.tensionAt(query) - expected).norm(), tolerance * tension.norm());
  }
}

const Eigen::Matrix3d TURN =
    Eigen::AngleAxisd(1.1, Direction(1, 2, 3).normalized()).toRotationMatrix();

TEST(IndicatorFieldFrame, TurnsWithTheModel)
{
  expectOnlyTheFrameToChange({TURN, 1.0, Eigen::Vector3d::Zero()}, 1e-12);
}

TEST(IndicatorFieldFrame, DoesNotFeelTheScale)
{
  for (const double scale : {1e-9, 1e-4, 1e6})
    expectOnlyTheFrameToChange(
        {Eigen::Matrix3d::Identity(), scale, Eigen::Vector3d::Zero()}, 1e-12);
}

TEST(IndicatorFieldFrame, DoesNotFeelAShift)
{
  expectOnlyTheFrameToChange({TURN, 1.0, {1e5, -2e5, 3e5}}, 1e-7);
}

} // namespace
} // namespace pcl::repair::test
