// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what ProjectionCompletion makes of parts of real models.

#include "completion_helpers.h"
#include "support/shared_data.h"

namespace pcl::ccaa::test {
namespace {

/** Real models with triangles, and how many patches go. */
struct RealModel {
  const char* name;
  const char* file;
  int patches;
};

const RealModel REAL_MODELS[] = {
    {"Femur", "femur/femur.ply", 12},
    {"Woman", "woman/human_woman.ply", 12},
    {"Fandisk", "fandisk/fandisk_large.ply", 16},
    {"LordQuas", "lordquas/lordquas.ply", 16},
    {"Parasaurolophus", "parasaurolophus/parasaurolophus_6700.ply", 8},
};

class PartialRealModel : public CompletionTest,
                         public ::testing::WithParamInterface<RealModel> {};

TEST_P(PartialRealModel, KeepsEveryGivenTriangleAndIsManifold)
{
  const std::string path = sharedData(GetParam().file);
  SKIP_WITHOUT_DATA(path);
  Shape model;
  ASSERT_TRUE(readShape(path, model));
  const Shape given = filteredToIcadm(withoutPatches(model, GetParam().patches, 2, 42));
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  EXPECT_TRUE(isIcadm(triangles, given.vertices.size()));
  EXPECT_TRUE(isConsistentlyWound(triangles));
  EXPECT_GT(triangles.size(), given.triangles.size());
}

INSTANTIATE_TEST_SUITE_P(Completion,
                         PartialRealModel,
                         ::testing::ValuesIn(REAL_MODELS),
                         [](const auto& one) { return one.param.name; });

} // namespace
} // namespace pcl::ccaa::test
