// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests that random damage never makes a repair go wrong.

#include "mesh/surface_topology.h"
#include "repair/decision_proposal.h"
#include "support/random_source.h"
#include "support/repair_fixture.h"

#include <memory>

namespace pcl::repair {
namespace {

using namespace test;

class RepairOfRandomDamage : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RepairOfRandomDamage, MakesNothingWorse)
{
  const std::uint64_t seed = GetParam();
  const DamagedModel made = randomlyDamaged(seed);
  if (made.wound.empty())
    return;
  RepairParameters parameters;
  parameters.survey.field.mode = seed % 4 == 0 ? FieldMode::FULL : FieldMode::LIGHT;
  parameters.refine = seed % 5 != 0;
  const Repaired result = repaired(toPolygonMesh(made.damaged), {}, parameters);
  expectNothingWorse(result, made.wound);
  EXPECT_TRUE(isConsistentlyWound(result.triangles()));
  EXPECT_LE(topologyOf(result.triangles()).components, made.whole.components);
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         RepairOfRandomDamage,
                         ::testing::Range<std::uint64_t>(1, 51));

TEST(RepairOfMixedWindings, IsThatOfAMeshWoundAlike)
{
  const Shape shape =
      inPieces(icosphere(3), [](const Position& p) { return p.z() > 0.8 ? -1 : 0; });
  const Triangles expected = repaired(toPolygonMesh(shape)).triangles();
  ASSERT_GT(expected.size(), shape.triangles.size());
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Shape mixed = shape;
    RandomSource random(seed);
    for (Triangle& triangle : mixed.triangles)
      if (random.uniform() < 0.1)
        std::swap(triangle[1], triangle[2]);
    EXPECT_TRUE(
        sameUnorientedTriangles(expected, repaired(toPolygonMesh(mixed)).triangles()));
  }
}

/** Whatever the method proposes, changed at random. */
Decisions
randomDecisions(const pcl::PolygonMesh& mesh, RandomSource& random)
{
  Decisions decisions = proposeDecisions(
      surveyModel(pcl::make_shared<pcl::PolygonMesh>(mesh), nullptr, {}, {}), {});
  for (LoopDecision& loop : decisions.loops) {
    loop.wish = static_cast<LoopWish>(random.below(3));
    loop.cap = static_cast<Cap>(random.below(3));
  }
  for (JunctionDecision& junction : decisions.junctions)
    junction.join = random.below(2) == 0;
  return decisions;
}

class RandomWishes : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomWishes, MakeNothingWorseAndLeaveOpenWhatIsToBeOpen)
{
  const DamagedModel made = randomlyDamaged(GetParam());
  if (made.wound.empty())
    return;
  RandomSource random(GetParam());
  const pcl::PolygonMesh mesh = toPolygonMesh(made.damaged);
  const Decisions decisions = randomDecisions(mesh, random);
  RepairParameters parameters;
  parameters.survey.decisions = std::make_shared<const Decisions>(decisions);
  parameters.filling.close = static_cast<CloseChoice>(random.below(3));
  parameters.filling.cap = static_cast<Cap>(random.below(3));
  const Repaired result = repaired(mesh, {}, parameters);
  expectNothingWorse(result, made.wound);
  for (const LoopDecision& loop : decisions.loops) {
    const auto is_it = [&](const RepairedHole& hole) {
      return hole.edges == loop.key.edges && hole.open != OpenReason::NONE &&
             !hole.shortfall;
    };
    EXPECT_TRUE(
        loop.wish != LoopWish::LEAVE_OPEN ||
        std::any_of(result.report.holes.begin(), result.report.holes.end(), is_it))
        << "loop at point " << loop.key.point;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomWishes, ::testing::Range<std::uint64_t>(1, 31));

} // namespace
} // namespace pcl::repair
