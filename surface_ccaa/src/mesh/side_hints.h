// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: hints about the outer side in other frames, and the origin
// as one of them.
#pragma once

#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/types.h>

#include "mesh/point_view.h"

namespace pcl::ccaa {

/** \brief Whether a cloud lies before the origin as before a sensor: within 45 degrees
 * of the mean direction, no nearer than 0.05 and no farther than 30 of its diagonals,
 * and at most a quarter of its points hidden behind others. Closed bodies and what lies
 * around the origin are not. Points that are not finite do not count. Cost: linear,
 * about 50 ns a point.
 * \param[in] chosen indices of points, or null for all */
bool
liesBeforeOrigin(const PointView& points, const Indices* chosen = nullptr);

/** \brief The hints in a frame with its origin at the offset: for what is worked on
 * less a global shift. Nobody has measured from the origin of map coordinates, so it is
 * not taken for a viewpoint there. */
SideHints
relativeTo(const Position& offset, SideHints hints);

/** \brief Take the origin for the viewpoint where that is allowed, nothing else is told
 * and the points lie before it. */
void
takeOrigin(SideHints& hints, const PointView& points, const Indices* chosen = nullptr);

} // namespace pcl::ccaa
