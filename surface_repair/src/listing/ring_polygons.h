// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the ring between two loops, cut open into polygons.

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::repair {

/** Part of the ring between two loops, as a polygon with the surface on
 * its left. A vertex may be there twice. */
struct RingPolygon {
  BoundaryCurve curve;
  std::vector<pcl::index_t> vertices; /**< of the whole */
  std::size_t second_loop = 0;        /**< see stitchRing(); 0: part of the ring */
};

/** \brief Places of two loops, the outer one's first. */
using LoopPlaces = std::pair<std::size_t, std::size_t>;

/** \brief Ways to make polygons of the ring between two loops, to be tried one after
 * the other: one polygon that runs over a bridge and back; where the loops touch, one
 * from each such place to the next. \param[in] touching places at which both have a
 * point in common, by ascending outer ones */
std::vector<std::vector<RingPolygon>>
cutsOf(const BoundaryLoop& outer,
       const BoundaryLoop& inner,
       const std::vector<LoopPlaces>& touching);

} // namespace pcl::repair
