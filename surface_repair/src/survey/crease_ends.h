// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sharp edges of the model that run out at a boundary.

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

class SurfaceEnds;

/** \brief Where a sharp edge or a narrow fold of an island runs out at its boundary:
 * beyond it a fair surface is creased as well. */
struct CreaseEnd {
  std::size_t vertex = 0;               /**< of the loop */
  Direction along = Direction::Zero();  /**< the way it would go on, unit */
  Direction normal = Direction::Zero(); /**< between both sides, unit, across `along` */
  bool is_convex = true;
  double edge = 0.0; /**< length of edges around, units of the cloud */
};

/** \brief Chains of sharp edges, all convex or all concave, that end at a loop. No two
 * share a vertex of the model, the sharpest come first. The direction is that of a
 * parabola through the last edges. Cost: some dozen operations for each edge of the
 * loop. */
std::vector<CreaseEnd>
creaseEnds(const IncompleteModel& model, const BoundaryLoop& loop);

/** \brief Places where the surface along a loop turns by more than a right angle within
 * a width, such as the rim of a thin plate: the middle of each turn. None within a
 * width of another, nor of those that are known.
 * \param[in,out] surface_ends of the model \param[in] width units of the cloud
 * \param[in] known ends at the loop */
std::vector<CreaseEnd>
foldEnds(SurfaceEnds& surface_ends,
         const BoundaryLoop& loop,
         double width,
         const std::vector<CreaseEnd>& known);

} // namespace pcl::repair
