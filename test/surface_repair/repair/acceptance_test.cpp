// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of damaged surfaces that must come out right.

#include "mesh/surface_topology.h"
#include "support/repair_fixture.h"

namespace pcl::repair {
namespace {

using namespace test;

struct SeededCase {
  RepairCase made;
  std::uint64_t seed = 0;
};

std::ostream&
operator<<(std::ostream& out, const SeededCase& tested)
{
  return out << tested.made.name << " of seed " << tested.seed;
}

std::vector<SeededCase>
seededCases()
{
  std::vector<SeededCase> cases;
  for (const std::uint64_t seed : {1U, 2U})
    for (RepairCase& made : allRepairCases(seed))
      cases.push_back({std::move(made), seed});
  return cases;
}

std::string
nameOf(const ::testing::TestParamInfo<SeededCase>& tested)
{
  return tested.param.made.name + "Seed" + std::to_string(tested.param.seed);
}

void
expectAllClosed(const RepairReport& report)
{
  EXPECT_TRUE(report.complete());
  for (const RepairedHole& hole : report.holes)
    EXPECT_FALSE(isShortfall(hole.open))
        << hole.edges << " edges: " << describe(hole.open);
}

class AcceptedRepair : public ::testing::TestWithParam<SeededCase> {};

TEST_P(AcceptedRepair, HasTheTopologyOfTheWholeAndLosesNothing)
{
  const DamagedModel made = GetParam().made.make();
  const Repaired result = repaired(toPolygonMesh(made.damaged), made.free_points);
  expectNothingWorse(result, made.wound);
  const Triangles triangles = result.triangles();
  const Topology found = topologyOf(triangles);
  EXPECT_EQ(made.whole.components, found.components);
  EXPECT_EQ(made.whole.characteristic, found.characteristic);
  EXPECT_EQ(made.whole.borders, found.borders);
  if (made.clear)
    expectAllClosed(result.report);
  if (GetParam().made.name == "Moebius")
    return; // no winding of it is consistent
  EXPECT_TRUE(isConsistentlyWound(triangles));
  EXPECT_EQ(0U, countMissing(made.wound, triangles)) << "wound the wrong way";
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         AcceptedRepair,
                         ::testing::ValuesIn(seededCases()),
                         nameOf);

} // namespace
} // namespace pcl::repair
