// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a number stands in a short row.
#pragma once

#include <pcl/types.h>

#include <cstdint>
#include <cstring>

namespace pcl::ccaa {

/** \brief The places among sixteen at which a value stands, as bits.
 *
 * All sixteen are compared: the answer is as good as random, and a mispredicted branch
 * would cost more than the whole comparison. */
inline std::uint32_t
matchSixteen(const index_t* slots, index_t value)
{
  using Four = index_t __attribute__((vector_size(4 * sizeof(index_t))));
  const Four wanted = {value, value, value, value};
  Four slot[4];
  std::memcpy(slot, slots, sizeof(slot));
  const Four match = ((slot[0] == wanted) & Four{0x1, 0x2, 0x4, 0x8}) |
                     ((slot[1] == wanted) & Four{0x10, 0x20, 0x40, 0x80}) |
                     ((slot[2] == wanted) & Four{0x100, 0x200, 0x400, 0x800}) |
                     ((slot[3] == wanted) & Four{0x1000, 0x2000, 0x4000, 0x8000});
  return static_cast<std::uint32_t>(match[0] | match[1] | match[2] | match[3]);
}

} // namespace pcl::ccaa
