// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cubes of the world into which a cloud is cut.
#include "tiles/world_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pcl::ccaa {
namespace {

/** Level of the eight octants of the whole space. */
constexpr int OCTANTS = 50;
/** Finest level: coordinates near the origin can always be told apart. */
constexpr int FINEST = -100;
/** Edges from the origin up to which a double tells halves of a cell apart. */
constexpr std::int64_t FARTHEST = std::int64_t{1} << 50;

} // namespace

bool
GridCell::canSplit() const
{
  return isWhole() || (level > FINEST && std::all_of(at.begin(), at.end(), [](auto x) {
                         return std::abs(x) < FARTHEST;
                       }));
}

GridCell
cellOf(const Position& position, int level)
{
  GridCell cell;
  cell.level = level;
  const double edges_in_a_unit = std::ldexp(1.0, -level);
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell.at[axis] = static_cast<std::int64_t>(
        std::floor(position[static_cast<Eigen::Index>(axis)] * edges_in_a_unit));
  return cell;
}

GridCell
childOf(const GridCell& cell, const Position& position)
{
  return cellOf(position, cell.isWhole() ? OCTANTS : cell.level - 1);
}

Position
roundedTo(double step, const Position& position)
{
  return step > 0.0 ? Position((position / step).array().round() * step) : position;
}

} // namespace pcl::ccaa
