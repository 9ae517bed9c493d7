// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the queries of a block have found.
#pragma once

#include "search/kernel/row_sort.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

/** Rows up to here are sorted by counting, which takes the square of their length. */
constexpr unsigned int SHORT_ROW = 192;

/** The next smaller float; below zero for zero. */
inline float
below(float distance)
{
  if (!(distance > 0.f))
    return -1.f;
  std::int32_t bits;
  __builtin_memcpy(&bits, &distance, sizeof bits);
  --bits;
  __builtin_memcpy(&distance, &bits, sizeof bits);
  return distance;
}

/** What each query has found so far, in the order of the ranks as far as it is equally
 * far away. */
class CandidateRows {
public:
  CandidateRows(const Scratch& scratch, unsigned int k)
  : scratch_(scratch)
  , k_(k)
  , full_(scratch.capacity - LANES)
  , distances_(scratch.distances)
  , ranks_(scratch.ranks)
  {
    for (unsigned int lane = 0; lane < LANES; ++lane)
      sizes_[lane] = 0;
  }

  void
  clear(unsigned int lane)
  {
    sizes_[lane] = 0;
  }

  /** Add the points of a block in this mask. Returns whether the row has no room for
   * another block, and has to be narrowed. */
  bool
  append(unsigned int lane,
         std::uint32_t block,
         const Floats& distances,
         unsigned int mask)
  {
    const unsigned int size = sizes_[lane];
    const unsigned int new_size = size + pack(distances,
                                              static_cast<std::int32_t>(block * LANES),
                                              mask,
                                              rowDistances(lane) + size,
                                              rowRanks(lane) + size);
    sizes_[lane] = new_size;
    return new_size > full_;
  }

  /** Keep the k best. Returns the bound for what may still come: if that has higher
   * ranks, then nothing more is wanted of what is equally far as the k-th. With many
   * equal points this is what ends the walk. */
  float
  narrow(unsigned int lane)
  {
    sizes_[lane] = sort(lane);
    for (unsigned int i = 0; i < sizes_[lane]; ++i) {
      rowDistances(lane)[i] = scratch_.sorted_distances[i];
      rowRanks(lane)[i] = scratch_.sorted_ranks[i];
    }
    return below(scratch_.sorted_distances[sizes_[lane] - 1]);
  }

  /** Sort a row; its first entries, k at most, are then in scratch. Returns how many.
   */
  unsigned int
  sort(unsigned int lane)
  {
    float* const distances = rowDistances(lane);
    std::int32_t* const ranks = rowRanks(lane);
    const unsigned int size = sizes_[lane];
    if (size > SHORT_ROW) {
      sortLongRow(distances, ranks, size);
      for (unsigned int i = 0; i < size; ++i)
        putSorted(i, distances[i], ranks[i]);
    }
    else {
      const std::int32_t largest = 0x7ffffffe;
      const unsigned int padded = (size + LANES - 1) / LANES * LANES;
      for (unsigned int i = size; i < padded; ++i)
        __builtin_memcpy(distances + i, &largest, sizeof largest);
      sortedPlaces(distances, padded, scratch_.places);
#pragma GCC unroll 4
      for (unsigned int i = 0; i < size; ++i)
        putSorted(
            static_cast<unsigned int>(scratch_.places[i]), distances[i], ranks[i]);
    }
    return size < k_ ? size : k_;
  }

private:
  float*
  rowDistances(unsigned int lane) const
  {
    return distances_ + std::size_t(lane) * (full_ + LANES);
  }

  std::int32_t*
  rowRanks(unsigned int lane) const
  {
    return ranks_ + std::size_t(lane) * (full_ + LANES);
  }

  void
  putSorted(unsigned int place, float distance, std::int32_t rank)
  {
    scratch_.sorted_distances[place] = distance;
    scratch_.sorted_ranks[place] = rank;
  }

  const Scratch& scratch_;
  unsigned int k_;
  /** A row of more entries than this has no room for another block. */
  unsigned int full_;
  float* distances_;
  std::int32_t* ranks_;
  unsigned int sizes_[LANES];
};

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
