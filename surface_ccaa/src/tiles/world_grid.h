// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cubes of the world into which a cloud is cut.
#pragma once

#include "mesh/triangle.h"

#include <array>
#include <cstdint>
#include <tuple>

namespace pcl::ccaa {

/** \brief A cube of the world grid: its edge is 2^level units, its lowest corner lies
 * at so many edges from the origin. The grid is the same for all clouds, so that a cut
 * depends on the points alone. Cubes are half open: every finite position lies in just
 * one cube of a level. */
struct GridCell {
  /** \brief Of the one cell that is the whole space. */
  static constexpr int WHOLE = 1024;

  int level = WHOLE;
  std::array<std::int64_t, 3> at{};

  bool
  isWhole() const
  {
    return level == WHOLE;
  }

  /** \brief Whether doubles can tell the cubes of the next finer level apart. */
  bool
  canSplit() const;

  bool
  operator<(const GridCell& other) const
  {
    return std::tie(level, at) < std::tie(other.level, other.at);
  }
  bool
  operator==(const GridCell& other) const
  {
    return level == other.level && at == other.at;
  }
};

/** \brief Greatest coordinate that the grid has cells for, about 10^15 units. */
constexpr double WORLD_EDGE = 1125899906842624.0; // 2^50

/** \brief The cell of a level, at most 50, in which a position lies, each coordinate of
 * which is less than WORLD_EDGE. */
GridCell
cellOf(const Position& position, int level);

/** \brief The cell of the next finer level in which a position of a cell lies. */
GridCell
childOf(const GridCell& cell, const Position& position);

/** \brief A position rounded to a multiple of a step, so that positions less a corner
 * of that lattice are exact floats: all tiles see the same. */
Position
roundedTo(double step, const Position& position);

} // namespace pcl::ccaa
