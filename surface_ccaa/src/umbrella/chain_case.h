// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the rows of the umbrella filter's table (T3.4-1).
#pragma once

#include "mesh/point_chains.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pcl::ccaa {

/** \brief The rows of table T3.4-1; the value is the row's number. */
enum class ChainCase : std::uint8_t {
  NO_CHAIN = 0,        /**< not in the table: a free point already */
  ONE_CLOSED = 1,      /**< internal point */
  ONE_OPEN = 2,        /**< boundary point, if its region is large enough (C3.4-3) */
  SEVERAL_OPEN = 3,    /**< all but the longest are deleted */
  CLOSED_AND_OPEN = 4, /**< the open ones are deleted */
  SEVERAL_CLOSED = 5   /**< all are deleted, open ones among them too */
};

/** \brief The row of T3.4-1 that a point's chains belong to. */
ChainCase
classifyChains(const PointChains& chains);

/** \brief The one chain that T3.4-1 leaves at a point: place in chains.chains(), or
 * nothing where all have to go (row 5) or there is none.
 *
 * Row 3 keeps the open chain with the most triangles. Where several have equally many,
 * the one that spans the larger sum of angles at the point covers more of the umbrella
 * and stays; angles within 1e-9 of each other count as equal, and then the chain
 * with the lexicographically lowest corner (x, then y, then z) stays. So the numbering
 * of points decides only where different points coincide (lowest triangle). */
std::optional<std::size_t>
survivingChain(const PointChains& chains,
               const Triangles& triangles,
               const Positions& positions,
               pcl::index_t vertex);

} // namespace pcl::ccaa
