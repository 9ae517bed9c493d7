// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests that random damage never makes a repair go wrong.

#include "repair_fixture.h"

namespace pcl {
namespace repair {
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

} // namespace
} // namespace repair
} // namespace pcl
