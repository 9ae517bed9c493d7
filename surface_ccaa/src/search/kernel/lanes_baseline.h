// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: eight numbers at a time, in portable loops.
#pragma once

#include "search/block_kernel.h"

namespace pcl {
namespace ccaa {
namespace block_kernel {
namespace baseline {

// The loops have a fixed length and no branch, so that the compiler turns them into
// what vector instructions every processor of the family has.

struct Floats {
  float lane[LANES];
};

struct Ints {
  std::int32_t lane[LANES];
};

template <class Function>
inline Floats
floatsOf(const Function& function)
{
  Floats result;
  for (unsigned int i = 0; i < LANES; ++i)
    result.lane[i] = function(i);
  return result;
}

template <class Function>
inline Ints
intsOf(const Function& function)
{
  Ints result;
  for (unsigned int i = 0; i < LANES; ++i)
    result.lane[i] = function(i);
  return result;
}

inline Floats
load(const float* from)
{
  return floatsOf([from](unsigned int i) { return from[i]; });
}

inline Floats
all(float value)
{
  return floatsOf([value](unsigned int) { return value; });
}

inline void
store(float* to, const Floats& a)
{
  for (unsigned int i = 0; i < LANES; ++i)
    to[i] = a.lane[i];
}

inline Floats
operator+(const Floats& a, const Floats& b)
{
  return floatsOf([&](unsigned int i) { return a.lane[i] + b.lane[i]; });
}

inline Floats
operator-(const Floats& a, const Floats& b)
{
  return floatsOf([&](unsigned int i) { return a.lane[i] - b.lane[i]; });
}

inline Floats
operator*(const Floats& a, const Floats& b)
{
  return floatsOf([&](unsigned int i) { return a.lane[i] * b.lane[i]; });
}

/** The larger; where either is NaN, the second. */
inline Floats
larger(const Floats& a, const Floats& b)
{
  return floatsOf(
      [&](unsigned int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
}

/** The smaller; where either is NaN, the second. */
inline Floats
smaller(const Floats& a, const Floats& b)
{
  return floatsOf(
      [&](unsigned int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
}

/** Bit i: a[i] <= b[i]. */
inline unsigned int
lessEqual(const Floats& a, const Floats& b)
{
  unsigned int mask = 0;
  for (unsigned int i = 0; i < LANES; ++i)
    mask |= static_cast<unsigned int>(a.lane[i] <= b.lane[i]) << i;
  return mask;
}

inline Ints
allInts(std::int32_t value)
{
  return intsOf([value](unsigned int) { return value; });
}

inline Ints
loadInts(const std::int32_t* from)
{
  return intsOf([from](unsigned int i) { return from[i]; });
}

inline void
storeInts(std::int32_t* to, const Ints& a)
{
  for (unsigned int i = 0; i < LANES; ++i)
    to[i] = a.lane[i];
}

inline Ints
bitsOf(const Floats& a)
{
  Ints result;
  __builtin_memcpy(&result, &a, sizeof result);
  return result;
}

inline Floats
floatsFromBits(const Ints& a)
{
  Floats result;
  __builtin_memcpy(&result, &a, sizeof result);
  return result;
}

inline Ints
operator+(const Ints& a, const Ints& b)
{
  return intsOf([&](unsigned int i) { return a.lane[i] + b.lane[i]; });
}

inline Ints
operator-(const Ints& a, const Ints& b)
{
  return intsOf([&](unsigned int i) { return a.lane[i] - b.lane[i]; });
}

/** -1 where a > b, else 0. */
inline Ints
greater(const Ints& a, const Ints& b)
{
  return intsOf([&](unsigned int i) { return -std::int32_t(a.lane[i] > b.lane[i]); });
}

/** a where the mask is -1, b where it is 0. */
inline Ints
select(const Ints& mask, const Ints& a, const Ints& b)
{
  return intsOf([&](unsigned int i) {
    return (mask.lane[i] & a.lane[i]) | (~mask.lane[i] & b.lane[i]);
  });
}

/** a / 2 for a that is not negative. */
inline Ints
half(const Ints& a)
{
  return intsOf([&](unsigned int i) { return a.lane[i] >> 1; });
}

inline unsigned int
bitCount(unsigned int mask)
{
  return static_cast<unsigned int>(__builtin_popcount(mask));
}

/** Write the lanes of the mask one after the other, with the ranks first_rank + lane;
 * whatever stands behind them, up to LANES, may change. Returns how many. */
inline unsigned int
pack(const Floats& distances,
     std::int32_t first_rank,
     unsigned int mask,
     float* distances_to,
     std::int32_t* ranks_to)
{
  unsigned int size = 0;
  for (; mask != 0; mask &= mask - 1, ++size) {
    const int lane = __builtin_ctz(mask);
    distances_to[size] = distances.lane[lane];
    ranks_to[size] = first_rank + lane;
  }
  return size;
}

} // namespace baseline
} // namespace block_kernel
} // namespace ccaa
} // namespace pcl
