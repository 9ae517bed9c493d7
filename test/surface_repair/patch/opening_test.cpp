// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of discs of new triangles that are opened.

#include <gtest/gtest.h>

#include "boundary/extraction.h"
#include "patch/opening.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <numeric>

namespace pcl::repair::test {
namespace {

/** A model all of which is new. */
GrowingSurface
newSurface(const Shape& shape)
{
  return {modelOf(shape), std::vector<std::size_t>(shape.triangles.size(), 0)};
}

ModelPart
wholeOf(const GrowingSurface& surface)
{
  std::vector<std::size_t> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return surface.part(all);
}

TEST(Opening, GrowsADiscOverWhatMayBeOpened)
{
  const GrowingSurface surface = newSurface(icosphere(2));
  const ModelPart part = wholeOf(surface);
  std::vector<bool> first(part.triangles.size(), false);
  first[0] = true;
  const Opening opening = openFrom(part, 0, ringsAround(part, first, 1));
  const auto opened = static_cast<std::size_t>(
      std::count(opening.is_open.begin(), opening.is_open.end(), true));
  EXPECT_GT(opened, 3U);
  ASSERT_FALSE(opening.border.empty());
  const std::size_t rim = opening.border.size();
  EXPECT_LE(rim, opened + 2); // equal where no vertex is within
}

TEST(Opening, OfAllThatThereIsHasNoLoopInWhatIsLeft)
{
  const GrowingSurface surface = newSurface(grid(2, 2));
  const ModelPart part = wholeOf(surface);
  Opening opening = openFrom(part, 0, std::vector<bool>(part.triangles.size(), true));
  std::fill(opening.is_open.begin(), opening.is_open.end(), true);
  ASSERT_FALSE(opening.border.empty());
  const ModelPart left = surface.part({});
  EXPECT_EQ(nullptr, loopOf(opening, part, left, extractBoundaries(left.model)));
}

/** Puts a vertex into the middle of a triangle. */
void
divide(std::size_t triangle, GrowingSurface& surface)
{
  const ModelPart part = surface.part({triangle});
  Patch patch;
  patch.rim = {0, 1, 2};
  patch.positions = part.model.positions;
  patch.positions.push_back(
      (patch.positions[0] + patch.positions[1] + patch.positions[2]) / 3.0);
  patch.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  surface.replace(replacementIn(part, {true}, part, patch), 0);
}

TEST(GrowingSurface, FindsWhatHasComeHoweverMuchItIs)
{
  GrowingSurface surface = newSurface(icosphere(1)); // of 80 triangles
  const ccaa::Box half(Position(-2.0, -2.0, -0.1), Position(2.0, 2.0, 2.0));
  for (std::size_t t = 0; t < 200; ++t) {
    divide(t, surface);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      if (surface.is_there[i] &&
          ccaa::boxOf(ccaa::cornersOf(surface.triangles[i], surface.positions))
              .intersects(half))
        expected.push_back(i);
    ASSERT_EQ(expected, surface.near(half)) << t;
  }
}

TEST(GrowingSurface, PatchesNearAreWhatIsNearAndClosesAHole)
{
  const Shape sphere = icosphere(1);
  std::vector<std::size_t> holes(sphere.triangles.size(), NONE);
  for (std::size_t t = 0; t < holes.size(); t += 3)
    holes[t] = 0;
  GrowingSurface surface(modelOf(sphere), holes);
  divide(3, surface);
  const ccaa::Box half(Position(-2.0, -2.0, -0.1), Position(2.0, 2.0, 2.0));
  std::vector<std::size_t> expected = surface.near(half);
  expected.erase(std::remove_if(expected.begin(),
                                expected.end(),
                                [&](std::size_t t) { return surface.hole[t] == NONE; }),
                 expected.end());
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(expected, surface.patchesNear(half));
}

} // namespace
} // namespace pcl::repair::test
