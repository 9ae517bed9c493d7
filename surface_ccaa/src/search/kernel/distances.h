// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: distances between points and boxes, eight at a time.
#pragma once

#include "search/kernel/lanes.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

constexpr float INFINITE = __builtin_inff();

/** Sum of squares, always in this order. */
inline Floats
sqrLength(const Floats& x, const Floats& y, const Floats& z)
{
  return x * x + y * y + z * z;
}

/** Distance from an interval to another along one axis; the second interval may have
 * NaN ends and then so is the result. */
inline Floats
gap(const Floats& low,
    const Floats& high,
    const Floats& box_low,
    const Floats& box_high)
{
  return larger(all(0.f), larger(low - box_high, box_low - high));
}

/** Eight places in space and the box around some of them. */
struct Queries {
  alignas(32) float x[LANES];
  alignas(32) float y[LANES];
  alignas(32) float z[LANES];
  float low[3];
  float high[3];

  void
  set(unsigned int lane, float qx, float qy, float qz)
  {
    x[lane] = qx;
    y[lane] = qy;
    z[lane] = qz;
  }

  /** Bound the queries of this mask, which is not empty. */
  void
  bound(unsigned int lanes)
  {
    const float* const axes[3] = {x, y, z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = INFINITE;
      high[axis] = -INFINITE;
      for (unsigned int rest = lanes; rest != 0; rest &= rest - 1) {
        const float value = axes[axis][__builtin_ctz(rest)];
        low[axis] = value < low[axis] ? value : low[axis];
        high[axis] = value > high[axis] ? value : high[axis];
      }
    }
  }
};

/** Bit i: box i of the group is within sqr_reach of the box around the queries. */
inline unsigned int
boxesInReach(const float* group, const Queries& queries, float sqr_reach)
{
  const auto gapAlong = [group, &queries](unsigned int axis) {
    return gap(all(queries.low[axis]),
               all(queries.high[axis]),
               load(group + axis * LANES),
               load(group + (axis + 3) * LANES));
  };
  return lessEqual(sqrLength(gapAlong(0), gapAlong(1), gapAlong(2)), all(sqr_reach));
}

/** Squared distances of a block's points to one place. */
inline Floats
sqrDistances(const float* block, float x, float y, float z)
{
  return sqrLength(load(block) - all(x),
                   load(block + LANES) - all(y),
                   load(block + 2 * LANES) - all(z));
}

/** Squared distances of a query to the boxes of a group. */
inline Floats
sqrGaps(const float* boxes, const Queries& queries, unsigned int lane)
{
  const auto gapAlong = [boxes](float place, unsigned int axis) {
    return gap(all(place),
               all(place),
               load(boxes + axis * LANES),
               load(boxes + (axis + 3) * LANES));
  };
  return sqrLength(gapAlong(queries.x[lane], 0),
                   gapAlong(queries.y[lane], 1),
                   gapAlong(queries.z[lane], 2));
}

/** Squared distances of a query to the middles of the boxes, times four. */
inline Floats
sqrOffsets(const float* boxes, const Queries& queries, unsigned int lane)
{
  const auto offsetAlong = [boxes](float place, unsigned int axis) {
    return load(boxes + axis * LANES) - all(place) +
           (load(boxes + (axis + 3) * LANES) - all(place));
  };
  return sqrLength(offsetAlong(queries.x[lane], 0),
                   offsetAlong(queries.y[lane], 1),
                   offsetAlong(queries.z[lane], 2));
}

/** Lane of the smallest value among those of a mask that is not empty. */
inline unsigned int
smallest(const float* values, unsigned int lanes)
{
  auto best = static_cast<unsigned int>(__builtin_ctz(lanes));
  for (unsigned int rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned int>(__builtin_ctz(rest));
    best = values[lane] < values[best] ? lane : best;
  }
  return best;
}

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
