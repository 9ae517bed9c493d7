// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of taking back relaxation.

#include <gtest/gtest.h>

#include "patch/relaxation_rollback.h"
#include "support/shapes.h"

#include <cmath>

namespace pcl::repair {
namespace {

using namespace ccaa::test;

constexpr int COLUMNS = 21;

/** A flat patch without a rim, lifted by 1. */
Patch
liftedPatch()
{
  const Shape shape = grid(COLUMNS, COLUMNS);
  Patch patch;
  patch.positions = shape.vertices;
  for (Position& position : patch.positions)
    position.z() = 1.0;
  patch.triangles = shape.triangles;
  patch.hole.assign(patch.triangles.size(), 0);
  patch.free_point.assign(patch.positions.size(), NONE);
  return patch;
}

TEST(RelaxationRollback, VerticesOfTheTrianglesGoBackAllTheWay)
{
  Patch patch = liftedPatch();
  rollBackRelaxation(grid(COLUMNS, COLUMNS).vertices, {0}, 0, patch);
  for (const pcl::index_t corner : patch.triangles[0])
    EXPECT_EQ(0.0, patch.positions[static_cast<std::size_t>(corner)].z());
}

TEST(RelaxationRollback, VerticesFarAwayStay)
{
  Patch patch = liftedPatch();
  rollBackRelaxation(grid(COLUMNS, COLUMNS).vertices, {0}, 0, patch);
  EXPECT_EQ(1.0, patch.positions.back().z());
}

TEST(RelaxationRollback, MoreRingsTakeMoreBack)
{
  Patch few = liftedPatch();
  Patch many = liftedPatch();
  const Positions before = grid(COLUMNS, COLUMNS).vertices;
  rollBackRelaxation(before, {0}, 0, few);
  rollBackRelaxation(before, {0}, 4, many);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_LE(many.positions[v].z(), few.positions[v].z());
  EXPECT_LT(many.positions[5].z(), few.positions[5].z());
}

TEST(RelaxationRollback, NoEdgeTakesAStepOfMoreThanAQuarter)
{
  Patch patch = liftedPatch();
  rollBackRelaxation(grid(COLUMNS, COLUMNS).vertices, {400}, 2, patch);
  for (const Triangle& triangle : patch.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LE(
          std::abs(
              patch.positions[static_cast<std::size_t>(triangle[c])].z() -
              patch.positions[static_cast<std::size_t>(triangle[(c + 1) % 3])].z()),
          0.25);
}

TEST(RelaxationRollback, HeldVerticesStay)
{
  Patch patch = liftedPatch();
  patch.free_point[0] = 7;
  rollBackRelaxation(grid(COLUMNS, COLUMNS).vertices, {0}, 0, patch);
  EXPECT_EQ(1.0, patch.positions[0].z());
}

} // namespace
} // namespace pcl::repair
