// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of one run in curve order, with their neighbors.
#pragma once

#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Single-precision coordinates, as the cloud holds them. */
using Coordinates = std::array<float, 3>;

/** \brief The usable points of a cloud (finite, selected, one per place) in the order
 * of a space-filling curve. The place of a point in this order is its \e rank;
 * everything in greedy/ speaks of ranks, so that neighbors in space are neighbors in
 * memory. */
struct RankedPoints {
  std::vector<Coordinates> coordinates; /**< by rank */
  std::vector<index_t> point_indices;   /**< rank -> index in the cloud */

  std::size_t
  size() const
  {
    return coordinates.size();
  }
};

/** \brief View of the k nearest neighbors of every ranked point: ranks, nearest first,
 * NONE from the end of a short row on; the point itself is not in its row. */
struct NeighborRows {
  static constexpr index_t NONE = -1;
  /** Neighbors of a point: votes for them are the bits of a word. */
  static constexpr unsigned int MOST = 64;

  const index_t* ranks = nullptr;
  unsigned int k = 0;

  const index_t*
  row(index_t rank) const
  {
    return ranks + static_cast<std::size_t>(rank) * k;
  }

  /** \brief Number of neighbors in a row. */
  unsigned int
  count(index_t rank) const
  {
    unsigned int filled = k;
    while (filled > 0 && row(rank)[filled - 1] == NONE)
      --filled;
    return filled;
  }
};

} // namespace pcl::ccaa
