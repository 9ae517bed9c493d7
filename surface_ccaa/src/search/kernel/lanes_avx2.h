// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: eight numbers at a time, in AVX2 registers.
#pragma once

#include "search/block_kernel.h"
#include <immintrin.h>

namespace pcl {
namespace ccaa {
namespace block_kernel {
namespace avx2 {

// The same operations as lanes_baseline.h, where they are explained.

struct Floats {
  __m256 lane;
};

struct Ints {
  __m256i lane;
};

inline Floats
load(const float* from)
{
  return {_mm256_loadu_ps(from)};
}

inline Floats
all(float value)
{
  return {_mm256_set1_ps(value)};
}

inline void
store(float* to, const Floats& a)
{
  _mm256_storeu_ps(to, a.lane);
}

inline Floats
operator+(const Floats& a, const Floats& b)
{
  return {_mm256_add_ps(a.lane, b.lane)};
}

inline Floats
operator-(const Floats& a, const Floats& b)
{
  return {_mm256_sub_ps(a.lane, b.lane)};
}

inline Floats
operator*(const Floats& a, const Floats& b)
{
  return {_mm256_mul_ps(a.lane, b.lane)};
}

inline Floats
larger(const Floats& a, const Floats& b)
{
  return {_mm256_max_ps(a.lane, b.lane)};
}

inline Floats
smaller(const Floats& a, const Floats& b)
{
  return {_mm256_min_ps(a.lane, b.lane)};
}

inline unsigned int
lessEqual(const Floats& a, const Floats& b)
{
  return static_cast<unsigned int>(
      _mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LE_OQ)));
}

inline Ints
allInts(std::int32_t value)
{
  return {_mm256_set1_epi32(value)};
}

inline Ints
loadInts(const std::int32_t* from)
{
  return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from))};
}

inline void
storeInts(std::int32_t* to, const Ints& a)
{
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), a.lane);
}

inline Ints
bitsOf(const Floats& a)
{
  return {_mm256_castps_si256(a.lane)};
}

inline Floats
floatsFromBits(const Ints& a)
{
  return {_mm256_castsi256_ps(a.lane)};
}

inline Ints
operator+(const Ints& a, const Ints& b)
{
  return {_mm256_add_epi32(a.lane, b.lane)};
}

inline Ints
operator-(const Ints& a, const Ints& b)
{
  return {_mm256_sub_epi32(a.lane, b.lane)};
}

inline Ints
greater(const Ints& a, const Ints& b)
{
  return {_mm256_cmpgt_epi32(a.lane, b.lane)};
}

inline Ints
select(const Ints& mask, const Ints& a, const Ints& b)
{
  return {_mm256_blendv_epi8(b.lane, a.lane, mask.lane)};
}

inline Ints
half(const Ints& a)
{
  return {_mm256_srli_epi32(a.lane, 1)};
}

inline unsigned int
bitCount(unsigned int mask)
{
  return static_cast<unsigned int>(__builtin_popcount(mask));
}

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

inline unsigned int
pack(const Floats& distances,
     std::int32_t first_rank,
     unsigned int mask,
     float* distances_to,
     std::int32_t* ranks_to)
{
  const __m256i lanes = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(PACKING.lanes[mask])));
  _mm256_storeu_ps(distances_to, _mm256_permutevar8x32_ps(distances.lane, lanes));
  storeInts(ranks_to, Ints{lanes} + allInts(first_rank));
  return bitCount(mask);
}

} // namespace avx2
} // namespace block_kernel
} // namespace ccaa
} // namespace pcl
