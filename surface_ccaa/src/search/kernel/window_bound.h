// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a bound for the k-th neighbor from the curve.
#pragma once

#include "search/kernel/distances.h"
#include "search/kernel/row_sort.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

/** Halvings of the interval that holds the bound, down to 1/16 of an octave. */
constexpr int BOUND_STEPS = 7;
/** Octaves of the interval, in the bits of a float. */
constexpr std::uint32_t OCTAVES = 8 << 23;

/** Upper bounds for the distance of the n-th nearest point, from the points of a few
 * blocks next to each other on the curve. */
class WindowBound {
public:
  /** A window around a block; the bounds are for the n-th nearest point, n = needed. */
  WindowBound(const BlockView& view,
              const Scratch& scratch,
              std::uint32_t block,
              unsigned int needed)
  : view_(view), distances_(scratch.window), needed_(needed)
  {
    width_ = scratch.window_blocks < view.blocks ? scratch.window_blocks : view.blocks;
    first_ = block < width_ / 2 ? 0 : block - width_ / 2;
    first_ = first_ > view.blocks - width_ ? view.blocks - width_ : first_;
  }

  /** Lower the bounds of the queries in this mask. */
  void
  tighten(const Queries& queries, unsigned int lanes, float* bounds)
  {
    if (!isEnough())
      return;
    alignas(32) float found[LANES];
    store(found, boundsOfAll(queries));
    for (unsigned int rest = lanes; rest != 0; rest &= rest - 1) {
      const int lane = __builtin_ctz(rest);
      bounds[lane] = found[lane] < bounds[lane] ? found[lane] : bounds[lane];
    }
  }

  /** The same for one query, with eight points at a time instead. */
  void
  tightenOne(const Queries& queries, unsigned int lane, float* bounds)
  {
    if (!isEnough())
      return;
    const float found = boundOfOne(queries.x[lane], queries.y[lane], queries.z[lane]);
    bounds[lane] = found < bounds[lane] ? found : bounds[lane];
  }

private:
  bool
  isEnough() const
  {
    const std::uint32_t end = (first_ + width_) * LANES;
    return (end < view_.size ? end : view_.size) - first_ * LANES >= needed_;
  }

  const float*
  points() const
  {
    return view_.coordinates + std::size_t(first_) * BLOCK_FLOATS;
  }

  /** Bisect the bits of the distances, which order as the distances do. */
  Floats
  boundsOfAll(const Queries& queries)
  {
    Ints high = bitsOf(measureAll(queries));
    const Ints octaves = high - all(OCTAVES);
    Ints low = select(greater(octaves, all(0u)), octaves, all(0u));
    const Ints surplus = all(width_ * LANES - needed_ + 1);
    for (int step = 0; step < BOUND_STEPS; ++step) {
      const Ints middle = low + half(high - low);
      const Ints enough = greater(surplus + minusBeyond(middle), all(0u));
      high = select(enough, middle, high);
      low = select(enough, low, middle);
    }
    return floatsFromBits(high);
  }

  /** Minus the number of points that are farther than this, per query. */
  Ints
  minusBeyond(const Ints& limit) const
  {
    Ints count = all(0u);
    const float* distances = distances_;
    for (std::uint32_t i = 0; i < width_; ++i, distances += LANES * LANES)
#pragma GCC unroll 8
      for (unsigned int j = 0; j < LANES; ++j)
        count = count + greater(bitsOf(load(distances + j * LANES)), limit);
    return count;
  }

  /** Distances of all points to all queries; returns the largest per query. */
  Floats
  measureAll(const Queries& queries)
  {
    const Floats x = load(queries.x), y = load(queries.y), z = load(queries.z);
    const float* block = points();
    float* to = distances_;
    Floats largest = all(0.f);
    for (std::uint32_t i = 0; i < width_; ++i, block += BLOCK_FLOATS)
#pragma GCC unroll 8
      for (unsigned int j = 0; j < LANES; ++j, to += LANES) {
        const Floats distances = sqrLength(all(block[j]) - x,
                                           all(block[j + LANES]) - y,
                                           all(block[j + 2 * LANES]) - z);
        store(to, distances);
        largest = larger(distances, largest);
      }
    return largest;
  }

  float
  boundOfOne(float x, float y, float z)
  {
    std::uint32_t high = keyOf(measureOne(x, y, z));
    std::uint32_t low = high > OCTAVES ? high - OCTAVES : 0;
    for (int step = 0; step < BOUND_STEPS; ++step) {
      const std::uint32_t middle = low + (high - low) / 2;
      const Floats limit = floatsFromBits(all(middle));
      unsigned int inside = 0;
      for (std::uint32_t i = 0; i < width_; ++i)
        inside += bitCount(lessEqual(load(distances_ + i * LANES), limit));
      (inside >= needed_ ? high : low) = middle;
    }
    float bound;
    __builtin_memcpy(&bound, &high, sizeof bound);
    return bound;
  }

  /** Distances of all points to one query; returns the largest. */
  float
  measureOne(float x, float y, float z)
  {
    Floats largest = all(0.f);
    for (std::uint32_t i = 0; i < width_; ++i) {
      const Floats distances = sqrDistances(points() + i * BLOCK_FLOATS, x, y, z);
      store(distances_ + i * LANES, distances);
      largest = larger(distances, largest);
    }
    alignas(32) float lanes[LANES];
    store(lanes, largest);
    for (unsigned int i = 1; i < LANES; ++i)
      lanes[0] = lanes[i] > lanes[0] ? lanes[i] : lanes[0];
    return lanes[0];
  }

  const BlockView& view_;
  float* distances_;
  unsigned int needed_;
  std::uint32_t first_;
  std::uint32_t width_;
};

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
