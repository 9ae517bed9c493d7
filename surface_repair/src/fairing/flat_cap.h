// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that lie in the plane of their rim.

#pragma once

#include "boundary/boundary_loop.h"
#include "filling/patch.h"

namespace pcl::repair {

/** \brief The plane that fits a rim best, and how the surface meets it. */
struct RimPlane {
  Position center = Position::Zero();
  Direction normal = Direction::UnitZ(); /**< to where the surface goes on */
  double size = 0.0;      /**< diameter: twice the distance of its points from the
                               centre, root mean square; units of the cloud */
  double residual = 0.0;  /**< distance from the plane, root mean square, in sizes */
  double steepness = 0.0; /**< mean sine of the angle between the surface, smoothed
                             along the rim, and the plane: 0 to 1 */
};

RimPlane
planeOf(const BoundaryCurve& rim);

/** \brief Whether a rim is a base, at which a smooth patch would be a dome: large,
 * plane, met steeply, and its island lies on one side of it. See doc/concepts/fairing.
 * \param[in] triangle of the model, at the rim. Cost: linear in the model, and only for
 * a rim that is the rest */
bool
isBase(const BoundaryCurve& rim, const IncompleteModel& model, pcl::index_t triangle);

/** \brief Bring the inner vertices of a patch, along the normal of its rim's plane, to
 * heights that the rim's ones continue without a maximum or minimum: over a plane rim
 * into the plane. Held vertices stay. Cost: one sparse linear system. */
void
flattenPatch(const IncompleteModel& model,
             Patch& patch,
             ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
