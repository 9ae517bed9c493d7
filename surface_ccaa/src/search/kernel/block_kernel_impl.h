// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the search kernel of one instruction set.
#pragma once

#include "search/kernel/nearest_search.h"
#include "search/kernel/range_search.h"

// One text for all instruction sets: included once per set, see run/registers.h.
// Exactness rests on two facts. Rounding is monotonic, so the distance to a box
// computed like the distance to a point is never above that of a point inside. And NaN
// loses every comparison, so the lanes that pad the last block and group drop out.

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

inline void
writeRow(const Scratch& scratch,
         unsigned int size,
         unsigned int k,
         std::int32_t* ranks,
         float* sqr_distances)
{
  for (unsigned int i = 0; i < size; ++i)
    ranks[i] = scratch.sorted_ranks[i];
  for (unsigned int i = size; i < k; ++i)
    ranks[i] = -1;
  if (sqr_distances == nullptr)
    return;
  for (unsigned int i = 0; i < size; ++i)
    sqr_distances[i] = scratch.sorted_distances[i];
  for (unsigned int i = size; i < k; ++i)
    sqr_distances[i] = INFINITE;
}

static void
nearestOfBlock(const BlockView& view,
               const Scratch& scratch,
               std::uint32_t block,
               unsigned int k,
               std::int32_t* ranks,
               float* sqr_distances)
{
  NearestSearch search(view, scratch, k);
  unsigned int rest = search.searchBlock(block);
  for (; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned int>(__builtin_ctz(rest));
    const std::size_t row = std::size_t(lane) * k;
    writeRow(scratch,
             search.sortRow(lane),
             k,
             ranks + row,
             sqr_distances == nullptr ? nullptr : sqr_distances + row);
  }
}

static unsigned int
nearestOfPlace(const BlockView& view,
               const Scratch& scratch,
               const float* query,
               float max_sqr_distance,
               unsigned int k,
               std::int32_t* ranks,
               float* sqr_distances)
{
  NearestSearch search(view, scratch, k);
  search.searchPlace(query, max_sqr_distance);
  const unsigned int size = search.sortRow(0);
  writeRow(scratch, size, size, ranks, sqr_distances);
  return size;
}

static unsigned int
within(const BlockView& view,
       RangeCursor& cursor,
       unsigned int capacity,
       std::int32_t* ranks,
       float* sqr_distances)
{
  return RangeSearch(view, cursor).run(capacity, ranks, sqr_distances);
}

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
