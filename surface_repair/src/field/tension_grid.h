// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tension of many free points on a sparse grid.
#pragma once

#include "field/falloff.h"
#include "icadm/incomplete_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief The sum of G over all free points (4.424) at nodes a quarter of R_2 apart,
 * linear between them; exactly 0 away from all points.
 *
 * Nodes lie in bricks that exist only near points. Building costs some ten microseconds
 * a point and up to 2 KB, a look-up ten nanoseconds. Const methods may be called from
 * several threads.
 */
class TensionGrid {
public:
  TensionGrid() = default;

  /** \param[in] tension G(0) of every point */
  TensionGrid(const Positions& points, const Falloff& falloff, double tension);

  /** \brief Mean of 1 / (1 + G) over so many equal parts of a segment, each judged by
   * its middle; exactly 1 where all of them are away from all points. */
  double
  meanShrink(const Position& a, const Position& b, int parts) const;

private:
  static constexpr int CELLS = 8; /**< along an edge of a brick */
  static constexpr int NODES = CELLS + 1;
  using Brick = std::array<float, NODES * NODES * NODES>;
  using Place = std::array<std::int32_t, 3>; /**< of a brick */

  static constexpr std::size_t NO_BRICK = static_cast<std::size_t>(-1);

  /** \brief A slot of the table that leads from places to bricks. */
  struct Slot {
    Place place = {};
    std::size_t brick = NO_BRICK;
  };

  void
  add(const Position& point, const Falloff& falloff, double tension);
  void
  addToBrick(const Place& place,
             const Position& point,
             const Falloff& falloff,
             double tension);
  std::size_t
  slotOf(const Place& place) const;
  std::size_t
  brickToWrite(const Place& place);
  void
  enlargeTable();

  /** \brief The tension at a place in cells; remembers the brick of the last look-up.
   */
  float
  at(const Position& cell, Slot& last) const;

  Position origin_ = Position::Zero(); /**< below all nodes */
  double cell_ = 1.0;                  /**< edge, in units of the cloud */
  Position size_ = Position::Zero();   /**< of the box with tension, in cells */
  std::vector<Slot> table_;
  std::vector<Brick> bricks_;
};

} // namespace pcl::repair
