// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: place of a cell along the Hilbert curve.
#pragma once

#include "mesh/morton_code.h"

#include <array>
#include <cstdint>

namespace pcl::ccaa::hilbert {

// The curve enters a cube at a corner and leaves it along an axis: 8 x 3 states. Within
// a cube it visits the octants in Gray code order, turned into the state's frame.
// Notation of Hamilton, "Compact Hilbert indices", Dalhousie University CS-2006-07.

constexpr unsigned int STATES = 24;

constexpr unsigned int
rotateLeft(unsigned int bits, unsigned int count)
{
  const unsigned int turn = count % 3;
  return ((bits << turn) | (bits >> (3 - turn))) & 7u;
}

constexpr unsigned int
grayCode(unsigned int i)
{
  return i ^ (i >> 1);
}

constexpr unsigned int
grayCodeInverse(unsigned int code)
{
  return code ^ (code >> 1) ^ (code >> 2);
}

/** Corner at which the curve enters octant w of its walk. */
constexpr unsigned int
entryCorner(unsigned int w)
{
  return w == 0 ? 0 : grayCode(2 * ((w - 1) / 2));
}

constexpr unsigned int
trailingOnes(unsigned int i)
{
  return (i & 1u) == 0 ? 0 : 1 + trailingOnes(i >> 1);
}

/** Axis along which the curve crosses octant w of its walk. */
constexpr unsigned int
crossingAxis(unsigned int w)
{
  return w == 0 ? 0 : trailingOnes(w % 2 == 0 ? w - 1 : w) % 3;
}

struct Step {
  std::uint8_t code;
  std::uint8_t state;
};

/** One level of the curve: octant to place in the walk and state inside the octant. */
constexpr Step
descend(unsigned int state, unsigned int octant)
{
  const unsigned int corner = state / 3;
  const unsigned int axis = state % 3;
  const unsigned int turned = rotateLeft(octant ^ corner, 3 - (axis + 1) % 3);
  const unsigned int w = grayCodeInverse(turned);
  const unsigned int next_corner = corner ^ rotateLeft(entryCorner(w), axis + 1);
  const unsigned int next_axis = (axis + crossingAxis(w) + 1) % 3;
  return {static_cast<std::uint8_t>(w),
          static_cast<std::uint8_t>(next_corner * 3 + next_axis)};
}

/** Two levels at once, to halve the chain of dependent look-ups. */
constexpr std::array<std::array<Step, 64>, STATES>
makeDoubleSteps()
{
  std::array<std::array<Step, 64>, STATES> steps{};
  for (unsigned int state = 0; state < STATES; ++state)
    for (unsigned int octants = 0; octants < 64; ++octants) {
      const Step outer = descend(state, octants >> 3);
      const Step inner = descend(outer.state, octants & 7u);
      steps[state][octants] = {
          static_cast<std::uint8_t>((outer.code << 3) | inner.code), inner.state};
    }
  return steps;
}

inline constexpr std::array<std::array<Step, 64>, STATES> DOUBLE_STEPS =
    makeDoubleSteps();

/** \brief Place of the cell (x, y, z) along the curve through a cube of 2^bits cells
 * per axis; \a bits is even and at most 20. */
inline std::uint64_t
code(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned int bits)
{
  const std::uint64_t octants = spreadBits(x) << 2 | spreadBits(y) << 1 | spreadBits(z);
  std::uint64_t result = 0;
  unsigned int state = 0;
  for (unsigned int shift = 3 * bits; shift > 0; shift -= 6) {
    const Step step = DOUBLE_STEPS[state][(octants >> (shift - 6)) & 63u];
    result = result << 6 | step.code;
    state = step.state;
  }
  return result;
}

} // namespace pcl::ccaa::hilbert
