// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what ForceLineHoleRepair says of a run while it goes on and
// when it has ended, well or not.

#include <pcl/console/print.h>
#include <pcl/search/organized.h>
#include <pcl/point_types.h>

#include "support/repair_fixture.h"

#include <string>

namespace pcl::repair {
namespace {

using namespace test;

/** PCL's errors are expected here and would only hide others. */
class RepairState : public ::testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }

  static Shape
  sphereWithAHole()
  {
    return inPieces(icosphere(3),
                    [](const Position& p) { return p.z() > 0.8 ? -1 : 0; });
  }
};

/** Stages of the passes over a body beside a band that stays open. */
std::vector<std::string>
passesOver(const Shape& body)
{
  const Shape beside_one_that_stays =
      joined(body, translated(moebiusBand(40), {5.0, 0.0, 0.0}));
  ForceLineHoleRepair repair;
  RepairParameters without_crumbs; // which would be looked at once more
  without_crumbs.crumb_triangles = 0;
  repair.setParameters(without_crumbs);
  repair.setInputMesh(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(beside_one_that_stays)));
  std::vector<std::string> stages;
  repair.setProgressCallback([&](const std::string& stage, double) {
    if (stage.compare(0, 7, "closing") == 0 &&
        (stages.empty() || stages.back() != stage))
      stages.push_back(stage);
    return true;
  });
  pcl::PolygonMesh output;
  repair.process(output);
  return stages;
}

TEST_F(RepairState, SaysWhichPassLooksAgain)
{
  const std::vector<std::string> expected{"closing", "closing, pass 2 of at most 5"};
  EXPECT_EQ(expected, passesOver(sphereWithAHole()));
}

TEST_F(RepairState, WholeHolesOfASheetAreNoReasonToLookAgain)
{
  const Shape sheet = inPieces(grid(20, 20), [](const Position& p) {
    return (p - Position(10.0, 10.0, 0.0)).norm() < 2.5 ? -1 : 0;
  });
  EXPECT_EQ(std::vector<std::string>{"closing"}, passesOver(sheet));
}

TEST_F(RepairState, IsNotCompleteBeforeARun)
{
  EXPECT_FALSE(RepairReport().complete());
  EXPECT_FALSE(ForceLineHoleRepair().getReport().complete());
}

TEST_F(RepairState, IsNotCompleteAfterAnError)
{
  RepairParameters out_of_range;
  out_of_range.survey.field.trust = 1.0;
  EXPECT_FALSE(repaired(sphereWithAHole(), out_of_range).report.complete());
  EXPECT_FALSE(repaired({icosphere(1).vertices, {}}).report.complete());
  pcl::PolygonMesh cut_off = toPolygonMesh(sphereWithAHole());
  cut_off.cloud.data.resize(cut_off.cloud.data.size() / 2);
  EXPECT_FALSE(repaired(cut_off).report.complete());
}

TEST_F(RepairState, IsNotCompleteAfterAnErrorThatFollowsASuccess)
{
  ForceLineHoleRepair repair;
  pcl::PolygonMesh output;
  repair.setInputMesh(
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(sphereWithAHole())));
  repair.process(output);
  ASSERT_TRUE(repair.getReport().complete());
  repair.setTrust(-1.0);
  repair.process(output);
  EXPECT_FALSE(repair.getReport().complete());
}

TEST_F(RepairState, RefusesASearchOfOrganisedCloudsForFreePoints)
{
  RepairParameters parameters;
  parameters.survey.field.search =
      pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>();
  const Repaired result = repaired(sphereWithAHole(), parameters);
  EXPECT_TRUE(result.output.polygons.empty());
  EXPECT_FALSE(result.report.complete());
}

} // namespace
} // namespace pcl::repair
