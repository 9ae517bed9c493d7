// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the ring between an opening and what lies within it.

#pragma once

#include "boundary/boundary_loop.h"
#include "filling/patch.h"
#include "repair/growing_surface.h"
#include "repair/surface_obstacle.h"

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

/** \brief Where two loops have a point of the cloud in common, by ascending outer
 * places.
 */
std::vector<LoopPlaces>
touchingPlaces(const GrowingSurface& surface,
               const BoundaryLoop& outer,
               const BoundaryLoop& inner);

/** \brief Ways to make polygons of the ring between two loops, to be tried one after
 * the other: one polygon that runs over a bridge and back; where the loops touch, one
 * from each such place to the next. \param[in] touching places at which both have a
 * point in common, by ascending outer ones */
std::vector<std::vector<RingPolygon>>
cutsOf(const BoundaryLoop& outer,
       const BoundaryLoop& inner,
       const std::vector<LoopPlaces>& touching);

/** \brief Where rings are closed. */
struct RingPlace {
  const ModelPart& part;            /**< what is known around it */
  const std::vector<bool>& is_open; /**< of the part's triangles: they go */
  const ModelPart& left;            /**< what stays of it, with the rings' vertices */
  ccaa::Box box;
};

/** \brief Fill polygons by minimum weight, refine and relax them, and let the surface
 * have them where they run into nothing.
 * \param[in] of_hole that they close \return whether it has them */
bool
closeRings(const std::vector<RingPolygon>& rings,
           const RingPlace& place,
           std::size_t of_hole,
           const Course& course,
           GrowingSurface& surface);

} // namespace pcl::repair
