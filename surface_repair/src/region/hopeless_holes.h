// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes of which it is told early that nothing closes them.

#pragma once

#include "filling/patch.h"
#include "patch/surface_obstacle.h"
#include "region/region.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief What speaks against a hole before it is filled (see crossedEdges() of a
 * polygon): each triangle at an edge that the surface crosses would meet it. */
OpenReason
crossedEdges(const HolePolygon& hole,
             const IncompleteModel& model,
             const SurfaceObstacle& obstacle,
             ccaa::RunControl* control = nullptr);

/** \brief Holes whose fills run through the surface in many places before anything is
 * faired, by ascending number: none of them is closed in any way. \param[in] patch of
 * plain fills \param[in,out] control told the work, may be null */
std::vector<std::size_t>
hopelessHoles(const Patch& patch,
              const SurfaceObstacle& obstacle,
              ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
