// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: places along a curve that fills space.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>

namespace pcl::ccaa {

/** \brief 21 bits spread out so that two free bits follow each. */
inline std::uint64_t
spreadBits(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffull;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffull;
  bits = (bits | bits << 8) & 0x100f00f00f00f00full;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
  bits = (bits | bits << 2) & 0x1249249249249249ull;
  return bits;
}

/** \brief In which a place along the curve is told. */
constexpr unsigned int MORTON_BITS = 63;

/** \brief Place along the Morton curve through the unit cube. */
inline std::uint64_t
mortonCode(const Eigen::Vector3d& share)
{
  constexpr double CELLS = 2097151.0; // along an edge: 2^21 - 1
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k)
    code |=
        spreadBits(static_cast<std::uint64_t>(std::clamp(share[k], 0.0, 1.0) * CELLS))
        << k;
  return code;
}

} // namespace pcl::ccaa
