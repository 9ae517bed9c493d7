// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the repair of real scans.

#include "support/repair_fixture.h"
#include "support/shared_data.h"

#include <cctype>

namespace pcl::repair {
namespace {

using namespace test;

struct RealModel {
  const char* file;
  bool closed; /**< nothing that should be closed stays open */
};

std::ostream&
operator<<(std::ostream& out, const RealModel& model)
{
  return out << model.file;
}

class RepairOfRealModels : public ::testing::TestWithParam<RealModel> {};

TEST_P(RepairOfRealModels, LosesNothingAndMakesNothingWorse)
{
  const std::string path = sharedData(GetParam().file);
  SKIP_WITHOUT_DATA(path);
  Shape shape;
  ASSERT_TRUE(readShape(path, shape));
  const Repaired result = repaired(shape);
  const Triangles triangles = result.triangles();
  EXPECT_TRUE(isIcadm(triangles, pointsOf(result.output)));
  EXPECT_TRUE(keepsPoints(result));
  EXPECT_TRUE(addsNoIntersection(result));
  EXPECT_TRUE(hasConsistentReport(result));
  EXPECT_TRUE(isSubsetOf(shape.triangles, trianglesOverPlaces(result)));
  if (GetParam().closed) {
    EXPECT_EQ(0U, result.report.shortfalls);
  }
}

std::string
nameOf(const ::testing::TestParamInfo<RealModel>& tested)
{
  std::string name;
  for (const char* c = tested.param.file; *c != '\0'; ++c)
    if (std::isalnum(static_cast<unsigned char>(*c)) != 0)
      name += *c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Files,
    RepairOfRealModels,
    ::testing::Values(RealModel{"bunny/bun_zipper.ply", true},
                      RealModel{"holes/StanfordBunny_pymeshfix.ply", true},
                      RealModel{"bunny/bun_zipper_res3.ply", false},
                      RealModel{"holes/building_patch.ply", false},
                      RealModel{"holes/elephant-with-holes.ply", false},
                      RealModel{"holes/holes.ply", true},
                      RealModel{"holes/many_small_holes.ply", true},
                      RealModel{"holes/plane_holes.ply", true},
                      RealModel{"bust/Laurana50k.ply", true},
                      RealModel{"woman/Human.ply", false},
                      RealModel{"parasaurolophus/parasaurolophus_6700.ply", false},
                      RealModel{"range_maps/lato180.ply", false},
                      RealModel{"range_maps/lato000.ply", false}),
    nameOf);

} // namespace
} // namespace pcl::repair
