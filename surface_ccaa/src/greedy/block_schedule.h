// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how edges are shared out so that threads never meet.
#pragma once

#include <pcl/types.h>

#include <cstddef>

namespace pcl::ccaa {

/** \brief Groups of consecutive ranks that double in size from level to level.
 *
 * A group of level 0 is a block of BLOCK points, compact in space because ranks follow
 * a curve; a group of level l is 2^l blocks. An edge belongs to the lowest level at
 * which one group holds both its ends and every point joined to both. Levels are worked
 * off in order, the groups of a level in any order or at once: two groups of one level
 * have no point in common, and an insertion touches only those points. So the result is
 * the same for any number of threads, and the working set of a block stays in the
 * cache. */
class BlockSchedule {
public:
  /** \brief log2 of the points per block. */
  static constexpr unsigned int BLOCK_BITS = 11;
  /** \brief Points per block. */
  static constexpr std::size_t BLOCK = std::size_t(1) << BLOCK_BITS;

  explicit BlockSchedule(std::size_t points) : points_(points)
  {
    while (groupCount(levels_ - 1) > 1)
      ++levels_;
  }

  unsigned int
  levels() const
  {
    return levels_;
  }

  std::size_t
  groupCount(unsigned int level) const
  {
    const std::size_t group = std::size_t(1) << (BLOCK_BITS + level);
    return (points_ + group - 1) / group;
  }

  std::size_t
  blockCount() const
  {
    return groupCount(0);
  }

  /** \brief First rank of a group. */
  std::size_t
  begin(unsigned int level, std::size_t group) const
  {
    return group << (BLOCK_BITS + level);
  }

  /** \brief One past the last rank of a group. */
  std::size_t
  end(unsigned int level, std::size_t group) const
  {
    const std::size_t past = (group + 1) << (BLOCK_BITS + level);
    return past < points_ ? past : points_;
  }

  /** \brief Lowest level at which one group holds both points. */
  static unsigned int
  levelOf(index_t a, index_t b)
  {
    unsigned int level = 0;
    auto difference = static_cast<std::size_t>(a ^ b) >> BLOCK_BITS;
    for (; difference != 0; difference >>= 1)
      ++level;
    return level;
  }

private:
  std::size_t points_;
  unsigned int levels_ = 1;
};

} // namespace pcl::ccaa
