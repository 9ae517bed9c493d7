// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cubes of the world, against the definition.
#include <gtest/gtest.h>

#include "support/random_source.h"
#include "tiles/world_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** Of any size and sign, on corners of cells now and then. */
Position
randomPlace(RandomSource& random)
{
  Position place;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(70)) - 25);
    place[axis] = size * random.uniform(-1.0, 1.0);
    if (random.below(3) == 0)
      place[axis] = std::ldexp(std::round(random.uniform(-9.0, 9.0)),
                               static_cast<int>(random.below(40)) - 20);
  }
  return place;
}

/** By the definition: half open, in plain numbers. */
bool
holds(const GridCell& cell, const Position& place)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double edge = std::ldexp(1.0, cell.level);
    const double x = place[static_cast<Eigen::Index>(axis)];
    if (!(double(cell.at[axis]) * edge <= x && x < double(cell.at[axis] + 1) * edge))
      return false;
  }
  return true;
}

GridCell
neighbor(GridCell cell, int step)
{
  for (std::size_t axis = 0; axis < 3; ++axis, step /= 3)
    cell.at[axis] += step % 3 - 1;
  return cell;
}

TEST(WorldGrid, APositionLiesInJustOneCellOfALevel)
{
  RandomSource random(1);
  for (int round = 0; round < 2000; ++round) {
    const Position place = randomPlace(random);
    // Cells that doubles can tell apart: those of canSplit() and coarser ones.
    const int finest =
        std::max(-100, static_cast<int>(std::ilogb(place.cwiseAbs().maxCoeff())) - 50);
    const int level =
        finest + static_cast<int>(random.below(static_cast<std::size_t>(51 - finest)));
    const GridCell cell = cellOf(place, level);
    ASSERT_EQ(cell.level, level);
    for (int step = 0; step < 27; ++step)
      ASSERT_EQ(holds(neighbor(cell, step), place), step == 13) << place.transpose();
  }
}

TEST(WorldGrid, ChildrenOfACellLieWithinItDownToTheFinest)
{
  RandomSource random(2);
  for (int round = 0; round < 200; ++round) {
    const Position place = randomPlace(random);
    GridCell cell;
    EXPECT_TRUE(cell.isWhole());
    int depth = 0;
    while (cell.canSplit()) {
      const GridCell child = childOf(cell, place);
      ASSERT_TRUE(holds(child, place));
      ASSERT_LT(child.level, cell.level);
      for (std::size_t axis = 0; axis < 3 && !cell.isWhole(); ++axis) {
        ASSERT_EQ(child.level, cell.level - 1);
        ASSERT_EQ(child.at[axis] >> 1, cell.at[axis]);
      }
      cell = child;
      ASSERT_LT(++depth, 200);
    }
  }
}

TEST(WorldGrid, SplittingTellsApartAllPlacesThatFloatsDo)
{
  // Doubles as far out as there are cells, one unit of the last place apart.
  RandomSource random(3);
  for (int round = 0; round < 500; ++round) {
    Position one = randomPlace(random), other = one;
    other.x() = std::nextafter(static_cast<float>(one.x()),
                               std::numeric_limits<float>::infinity());
    one.x() = static_cast<float>(one.x());
    if (std::abs(other.x() - one.x()) < 0x1p-99)
      continue;
    GridCell cell;
    while (cell.canSplit() && childOf(cell, one) == childOf(cell, other))
      cell = childOf(cell, one);
    // Other axes may end the splitting sooner where they are much larger.
    if (std::max(std::abs(one.y()), std::abs(one.z())) <= std::abs(one.x())) {
      ASSERT_TRUE(cell.canSplit()) << one.transpose();
    }
  }
}

TEST(WorldGrid, RoundedPlacesLessACornerAreExactFloats)
{
  RandomSource random(5);
  for (int round = 0; round < 2000; ++round) {
    const Position corner_place(
        random.uniform(-1e7, 1e7), random.uniform(-1e7, 1e7), 0.0);
    const double extent =
        std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.below(30)) - 10);
    const double step = std::ldexp(1.0, std::ilogb(extent) - 24);
    const Position corner = roundedTo(step, corner_place);
    const Position place = corner_place + 0.5 * extent *
                                              Position(random.uniform(-1.0, 1.0),
                                                       random.uniform(-1.0, 1.0),
                                                       random.uniform(-1.0, 1.0));
    const Position rounded = roundedTo(step, place);
    ASSERT_LE((rounded - place).cwiseAbs().maxCoeff(),
              0.5 * step + 1e-15 * place.cwiseAbs().maxCoeff());
    const Position relative = rounded - corner;
    ASSERT_EQ(relative.cast<float>().cast<double>(), relative);
  }
  EXPECT_EQ(roundedTo(0.0, Position(0.1, 0.2, 0.3)), Position(0.1, 0.2, 0.3));
}

} // namespace
} // namespace pcl::ccaa::test
