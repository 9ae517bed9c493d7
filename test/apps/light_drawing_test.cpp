// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn while the camera moves, without a window.
#include <gtest/gtest.h>

#include "render/drawing.h"
#include "render/mesh_parts.h"
#include "repair_fixture.h"
#include "viewer/light_drawing.h"

namespace app_test {
namespace {

vtkPolyData&
drawn(vtkActor& actor)
{
  return *vtkPolyData::SafeDownCast(actor.GetMapper()->GetInput());
}

TEST(LightDrawing, DrawsALargeSurfaceCoarselyAndThenAsItIs)
{
  const auto parts = app::takeApart(test::toPolygonMesh(test::grid(300, 300)));
  const auto actor = app::makeFaces(parts.faces, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0});
  app::LightDrawing light;
  light.lighten(*actor);
  EXPECT_GT(drawn(*actor).GetNumberOfPolys(), 5000);
  EXPECT_LT(drawn(*actor).GetNumberOfPolys(), 100000);
  double full[6];
  double coarse[6];
  parts.faces->GetBounds(full);
  drawn(*actor).GetBounds(coarse);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(full[i], coarse[i], 5.0);
  light.restore();
  EXPECT_EQ(parts.faces.Get(), &drawn(*actor));
}

TEST(LightDrawing, DrawsSomeOfManyDotsAndSmallPartsAsTheyAre)
{
  const auto dots = app::takeApart(test::toPolygonMesh(test::grid(400, 400)).cloud, {});
  const auto many = app::makeMarks(dots.free_points, {0.0, 0.0, 0.0}, 1.0);
  ASSERT_GT(dots.free_points->GetNumberOfVerts(), 100000);
  const auto parts = app::takeApart(test::toPolygonMesh(test::grid(100, 100)));
  const auto small = app::makeFaces(parts.faces, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0});
  app::LightDrawing light;
  light.lighten(*many);
  light.lighten(*small);
  EXPECT_GT(drawn(*many).GetNumberOfVerts(), 50000);
  EXPECT_LE(drawn(*many).GetNumberOfVerts(), 100000);
  EXPECT_EQ(parts.faces.Get(), &drawn(*small));
}

} // namespace
} // namespace app_test
