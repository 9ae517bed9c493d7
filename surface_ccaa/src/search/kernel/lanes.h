// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: eight numbers at a time, in as many registers as it takes.
#pragma once

#include "run/registers.h"
#include "search/block_kernel.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

template <typename T>
using Register = ccaa::PCL_KERNEL::Register<T>;

constexpr unsigned int WIDTH = PCL_REGISTER_BYTES / 4;
constexpr unsigned int PARTS = LANES / WIDTH;

template <typename T>
struct Lanes {
  Register<T> part[PARTS];
};
using Floats = Lanes<float>;
/** Whole numbers by their bits: sums may wrap, and be put in another order. */
using Ints = Lanes<std::uint32_t>;

/** Of the parts function(0), function(1), ... */
template <typename T, class Function>
inline Lanes<T>
lanesOf(const Function& function)
{
  Lanes<T> lanes;
  for (unsigned int i = 0; i < PARTS; ++i)
    lanes.part[i] = function(i);
  return lanes;
}

template <typename T>
inline Lanes<T>
load(const T* from)
{
  return lanesOf<T>(
      [from](unsigned int i) { return ccaa::PCL_KERNEL::load(from + i * WIDTH); });
}

template <typename T>
inline Lanes<T>
all(T value)
{
  return lanesOf<T>([value](unsigned int) { return ccaa::PCL_KERNEL::all(value); });
}

template <typename T>
inline void
store(void* to, const Lanes<T>& a)
{
  for (unsigned int i = 0; i < PARTS; ++i)
    __builtin_memcpy(static_cast<char*>(to) + i * PCL_REGISTER_BYTES,
                     &a.part[i],
                     PCL_REGISTER_BYTES);
}

template <typename T>
inline Lanes<T>
operator+(const Lanes<T>& a, const Lanes<T>& b)
{
  return lanesOf<T>([&](unsigned int i) { return a.part[i] + b.part[i]; });
}

template <typename T>
inline Lanes<T>
operator-(const Lanes<T>& a, const Lanes<T>& b)
{
  return lanesOf<T>([&](unsigned int i) { return a.part[i] - b.part[i]; });
}

inline Floats
operator*(const Floats& a, const Floats& b)
{
  return lanesOf<float>([&](unsigned int i) { return a.part[i] * b.part[i]; });
}

/** The larger; where either is NaN, the second. */
inline Floats
larger(const Floats& a, const Floats& b)
{
  return lanesOf<float>(
      [&](unsigned int i) { return ccaa::PCL_KERNEL::larger(a.part[i], b.part[i]); });
}

/** Bit i: a[i] <= b[i]. */
inline unsigned int
lessEqual(const Floats& a, const Floats& b)
{
#if PCL_REGISTER_BYTES == 32
  return static_cast<unsigned int>(_mm256_movemask_ps(
      _mm256_cmp_ps((__m256)a.part[0], (__m256)b.part[0], _CMP_LE_OQ)));
#else
  unsigned int mask = 0;
  for (unsigned int i = 0; i < LANES; ++i)
    mask |= static_cast<unsigned int>(a.part[i / WIDTH][i % WIDTH] <=
                                      b.part[i / WIDTH][i % WIDTH])
            << i;
  return mask;
#endif
}

inline Ints
bitsOf(const Floats& a)
{
  return lanesOf<std::uint32_t>(
      [&](unsigned int i) { return (Register<std::uint32_t>)a.part[i]; });
}

inline Floats
floatsFromBits(const Ints& a)
{
  return lanesOf<float>([&](unsigned int i) { return (Register<float>)a.part[i]; });
}

/** -1 where a > b, else 0; of numbers with a sign. */
inline Ints
greater(const Ints& a, const Ints& b)
{
  using Signed = Register<std::int32_t>;
  return lanesOf<std::uint32_t>([&](unsigned int i) {
    return (Register<std::uint32_t>)((Signed)a.part[i] > (Signed)b.part[i]);
  });
}

/** a where the mask is -1, b where it is 0. */
inline Ints
select(const Ints& mask, const Ints& a, const Ints& b)
{
  return lanesOf<std::uint32_t>([&](unsigned int i) {
    return (mask.part[i] & a.part[i]) | (~mask.part[i] & b.part[i]);
  });
}

inline Ints
half(const Ints& a)
{
  return lanesOf<std::uint32_t>([&](unsigned int i) { return a.part[i] >> 1; });
}

inline unsigned int
bitCount(unsigned int mask)
{
  return static_cast<unsigned int>(__builtin_popcount(mask));
}

#if PCL_REGISTER_BYTES == 32
/** For each mask of eight lanes, the lanes in it one after the other. */
struct PackingTable {
  alignas(64) std::uint8_t lanes[256][LANES];
};

constexpr PackingTable
makePackingTable()
{
  PackingTable table{};
  for (unsigned int mask = 0; mask < 256; ++mask)
    for (unsigned int lane = 0, size = 0; lane < LANES; ++lane)
      if (mask & (1u << lane))
        table.lanes[mask][size++] = static_cast<std::uint8_t>(lane);
  return table;
}

inline constexpr PackingTable PACKING = makePackingTable();
#endif

/** Write the lanes of the mask one after the other, with the ranks first_rank + lane;
 * whatever stands behind them, up to LANES, may change. Returns how many. */
inline unsigned int
pack(const Floats& distances,
     std::int32_t first_rank,
     unsigned int mask,
     float* distances_to,
     std::int32_t* ranks_to)
{
#if PCL_REGISTER_BYTES == 32
  const __m256i lanes = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(PACKING.lanes[mask])));
  _mm256_storeu_ps(distances_to,
                   _mm256_permutevar8x32_ps((__m256)distances.part[0], lanes));
  store(ranks_to,
        Ints{(Register<std::uint32_t>)lanes} + all(std::uint32_t(first_rank)));
  return bitCount(mask);
#else
  float all_distances[LANES];
  store(all_distances, distances);
  unsigned int size = 0;
  for (; mask != 0; mask &= mask - 1, ++size) {
    const int lane = __builtin_ctz(mask);
    distances_to[size] = all_distances[lane];
    ranks_to[size] = first_rank + lane;
  }
  return size;
#endif
}

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
