// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the contours of holes that the viewer shows.
#include <gtest/gtest.h>

#include "inspect/inspection.h"
#include "inspect/inspection_colors.h"
#include "io/point_columns.h"
#include "repair_fixture.h"
#include "support/repair_shapes.h"
#include "viewer_fixture.h"

#include <map>
#include <set>
#include <vector>

namespace app_test {
namespace {

pcl::PolygonMesh
holedSphere()
{
  return test::toPolygonMesh(test::withoutTriangles(test::icosphere(3), {0, 1, 2, 3}));
}

TEST(HoleContours, HaveTheEdgesOfAClosedHole)
{
  const app::ViewerRun run = runForViewer(holedSphere());
  ASSERT_EQ(1U, run.repair.holes.size());
  const app::InspectionLayer layer = app::showContours(run.repair, run.result);
  EXPECT_EQ(run.repair.holes[0].edges, layer.lines.size());
}

TEST(HoleContours, FollowTheBoundaryOfAnOpenHole)
{
  pcl::repair::RepairParameters method;
  method.filling.greatest_hole = 3;
  const app::ViewerRun run = runForViewer(holedSphere(), method);
  ASSERT_EQ(1U, run.repair.holes.size());
  ASSERT_EQ(pcl::OpenReason::TOO_LARGE, run.repair.holes[0].open);
  const app::InspectionLayer layer = app::showContours(run.repair, run.result);
  EXPECT_EQ(run.repair.holes[0].edges, layer.lines.size());
  ASSERT_EQ(1U, layer.legend.size());
  EXPECT_EQ(app::colorOf(pcl::OpenReason::TOO_LARGE), layer.legend[0].color);
}

TEST(HoleContours, AreClosedAroundEveryHoleAlsoAlongBridges)
{
  const app::ViewerRun run = runForViewer(twoCaps());
  ASSERT_GT(run.repair.bridges.size(), 1U);
  const app::InspectionLayer layer = app::showContours(run.repair, run.result);
  // Places of line ends, by hole: a closed contour comes to each as often as it leaves.
  std::map<std::vector<double>, int> ends;
  std::set<double> holes;
  for (std::size_t i = 0; i < app::pointCount(layer.cloud); ++i) {
    const double hole = valueOf(layer.cloud, i, "hole");
    holes.insert(hole);
    ++ends[{hole,
            valueOf(layer.cloud, i, "x"),
            valueOf(layer.cloud, i, "y"),
            valueOf(layer.cloud, i, "z")}];
  }
  EXPECT_EQ(run.repair.holes.size(), holes.size());
  for (const auto& end : ends)
    EXPECT_EQ(0, end.second % 2) << testing::PrintToString(end.first);
}

TEST(HoleContours, AreNoneOfAClosedSurface)
{
  const app::ViewerRun run = runForViewer(test::toPolygonMesh(test::icosphere(2)));
  EXPECT_TRUE(app::showContours(run.repair, run.result).lines.empty());
}

} // namespace
} // namespace app_test
