// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sorting a short row by counting.
#pragma once

#include "search/kernel/lanes.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

/** The bits of a distance that is not negative order as the distance does. */
inline std::uint32_t
keyOf(const float& distance)
{
  std::uint32_t bits;
  __builtin_memcpy(&bits, &distance, sizeof bits);
  return bits;
}

/** Keys that are 1 more in the lanes after one, so that there "greater" says "greater
 * or equal". */
inline Ints
raisedAfter(unsigned int lane, const Ints& keys)
{
  alignas(32) static constexpr std::uint32_t STEP[2 * LANES] = {
      0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  return keys + load(STEP + LANES - 1 - lane);
}

/** Places of CHUNKS * LANES entries of a row when the row is sorted: how many entries
 * are smaller, or equal and earlier. So many chunks stay in registers while the row
 * passes. */
template <unsigned int CHUNKS>
inline void
placesOfChunks(const float* row,
               unsigned int size,
               unsigned int begin,
               std::int32_t* places)
{
  Ints keys[CHUNKS], raised[CHUNKS], counts[CHUNKS];
  for (unsigned int i = 0; i < CHUNKS; ++i) {
    keys[i] = bitsOf(load(row + begin + i * LANES));
    raised[i] = keys[i] + all(1u);
    counts[i] = all(0u);
  }
  const auto countAgainst = [&counts](const Ints* own, float other) {
    const Ints key = all(keyOf(other));
    for (unsigned int i = 0; i < CHUNKS; ++i)
      counts[i] = counts[i] - greater(own[i], key);
  };
  for (unsigned int j = 0; j < begin; ++j)
    countAgainst(raised, row[j]);
#pragma GCC unroll 4
  for (unsigned int chunk = 0; chunk < CHUNKS; ++chunk)
#pragma GCC unroll 8
    for (unsigned int lane = 0; lane < LANES; ++lane) {
      Ints mixed[CHUNKS];
      for (unsigned int i = 0; i < CHUNKS; ++i)
        mixed[i] = i < chunk   ? keys[i]
                   : i > chunk ? raised[i]
                               : raisedAfter(lane, keys[i]);
      countAgainst(mixed, row[begin + chunk * LANES + lane]);
    }
  for (unsigned int j = begin + CHUNKS * LANES; j < size; ++j)
    countAgainst(keys, row[j]);
  for (unsigned int i = 0; i < CHUNKS; ++i)
    store(places + begin + i * LANES, counts[i]);
}

/** The size is a multiple of LANES; what pads the row has the largest key. */
inline void
sortedPlaces(const float* row, unsigned int size, std::int32_t* places)
{
  unsigned int begin = 0;
  for (; begin + 4 * LANES <= size; begin += 4 * LANES)
    placesOfChunks<4>(row, size, begin, places);
  switch ((size - begin) / LANES) {
  case 1:
    return placesOfChunks<1>(row, size, begin, places);
  case 2:
    return placesOfChunks<2>(row, size, begin, places);
  case 3:
    return placesOfChunks<3>(row, size, begin, places);
  default:
    return;
  }
}

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
