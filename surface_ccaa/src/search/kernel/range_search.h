// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all points up to a distance from a query.
#pragma once

#include "search/kernel/distances.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

/** Points within a distance, in the order of their ranks. */
class RangeSearch {
public:
  RangeSearch(const BlockView& view, RangeCursor& cursor) : view_(view), cursor_(cursor)
  {
    for (unsigned int lane = 0; lane < LANES; ++lane)
      queries_.set(lane, cursor.query[0], cursor.query[1], cursor.query[2]);
    queries_.bound(1);
  }

  unsigned int
  run(unsigned int capacity, std::int32_t* ranks, float* sqr_distances)
  {
    first_block_ = cursor_.next_block;
    capacity_ = capacity;
    ranks_ = ranks;
    sqr_distances_ = sqr_distances;
    if (walk(view_.top, 0))
      cursor_.next_block = view_.blocks;
    return size_;
  }

private:
  /** Returns false when the room is full; the cursor then tells where to go on. */
  bool
  walk(unsigned int level, std::uint32_t group)
  {
    const float* boxes = view_.boxes[level] + std::size_t(group) * GROUP_FLOATS;
    unsigned int rest = boxesInReach(boxes, queries_, cursor_.max_sqr_distance);
    for (; rest != 0; rest &= rest - 1) {
      const std::uint32_t child =
          group * LANES + static_cast<unsigned int>(__builtin_ctz(rest));
      if (child < (first_block_ >> (3 * level)))
        continue;
      if (!(level == 0 ? take(child) : walk(level - 1, child)))
        return false;
    }
    return true;
  }

  bool
  take(std::uint32_t block)
  {
    if (capacity_ - size_ < LANES) {
      cursor_.next_block = block;
      return false;
    }
    const Floats distances =
        sqrDistances(view_.coordinates + std::size_t(block) * BLOCK_FLOATS,
                     queries_.x[0],
                     queries_.y[0],
                     queries_.z[0]);
    size_ += pack(distances,
                  static_cast<std::int32_t>(block * LANES),
                  lessEqual(distances, all(cursor_.max_sqr_distance)),
                  sqr_distances_ + size_,
                  ranks_ + size_);
    return true;
  }

  const BlockView& view_;
  RangeCursor& cursor_;
  Queries queries_;
  std::uint32_t first_block_ = 0;
  unsigned int capacity_ = 0;
  unsigned int size_ = 0;
  std::int32_t* ranks_ = nullptr;
  float* sqr_distances_ = nullptr;
};

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
