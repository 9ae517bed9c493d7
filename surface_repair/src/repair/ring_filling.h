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

namespace pcl {
namespace repair {

/** Part of the ring between two loops, as a polygon with the surface on
 * its left. A vertex may be there twice. */
struct RingPolygon {
  BoundaryCurve curve;
  std::vector<pcl::index_t> vertices; /**< of the whole */
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

/** \brief Fill polygons by minimum weight. \param[in] part that has their vertices
 * \param[in] obstacle to be avoided, or null \return without triangles where one of
 * them cannot be filled */
Patch
fillRings(const std::vector<RingPolygon>& rings,
          const ModelPart& part,
          const SurfaceObstacle* obstacle);

} // namespace repair
} // namespace pcl
