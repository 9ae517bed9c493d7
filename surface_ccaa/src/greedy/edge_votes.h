// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a point says of the edges to its neighbors.
#pragma once

#include <cstdint>

namespace pcl::ccaa {

/** \brief What a point says of the edges to its neighbors; bit j stands for the j-th
 * neighbor of its row. */
struct EdgeVotes {
  std::uint64_t in_reach = 0;  /**< not longer than the length limit of this point */
  std::uint64_t certified = 0; /**< in reach, and passes the empty-circle test */
  float reach = 0; /**< the length limit of this point, in units of the cloud */
};

} // namespace pcl::ccaa
