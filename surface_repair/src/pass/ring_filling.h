// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the ring between an opening and what lies within it.

#pragma once

#include "filling/patch.h"
#include "listing/ring_polygons.h"
#include "pass/passes.h"
#include "patch/growing_surface.h"
#include "patch/surface_obstacle.h"

#include <optional>
#include <vector>

namespace pcl::repair {

/** \brief Where two loops have a point of the cloud in common, by ascending outer
 * places.
 */
std::vector<LoopPlaces>
touchingPlaces(const GrowingSurface& surface,
               const BoundaryLoop& outer,
               const BoundaryLoop& inner);

/** \brief Where rings are closed. */
struct RingPlace {
  const ModelPart& part;            /**< what is known around it */
  const std::vector<bool>& is_open; /**< of the part's triangles: they go */
  const ModelPart& left;            /**< what stays of it, with the rings' vertices */
  ccaa::Box box;
  ccaa::RunControl* control; /**< told the work, may be null */
  SurfaceObstacle obstacle{left.model, {box}, 1, control}; /**< what stays there */
};

/** \brief Fill the polygons of one cut by minimum weight, refine and relax them; where
 * that fails, those of the next one.
 * \return what comes in place of what goes, if it runs into nothing */
std::optional<Replacement>
closeRing(const std::vector<std::vector<RingPolygon>>& cuts,
          const RingPlace& place,
          const Course& course);

} // namespace pcl::repair
