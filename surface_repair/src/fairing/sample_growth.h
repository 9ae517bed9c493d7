// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch that grows over samples of the missing surface.

#pragma once

#include "filling/patch.h"
#include "mesh/corners.h"
#include "run/run_control.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::repair {

/** \brief Make samples vertices of a coarse patch, one after the other in the order
 * given: so it grows over what they describe, however far from the rim, and stays the
 * disc that it was all the time.
 *
 * Each replaces the disc of triangles near it that leaves the surface the least bent:
 * the total absolute mean curvature, sum of |edge| times the angle between its normals,
 * falls with every flip afterwards, too (after Dyn, Hormann, Kim and Levin 2001). No
 * new triangle runs into the patch or what is obstructed; what finds no room is left
 * out. Cost: quadratic in the samples, some 0.1 us each pair; of more than 4000 only
 * every k-th is taken. \param[in] samples free points, those near the rim first; held
 * afterwards \param[in] obstructed whether a triangle runs into other surface
 * \param[in] control once it says stop the patch is worth nothing */
void
growOver(const IncompleteModel& model,
         const std::vector<std::size_t>& samples,
         const std::function<bool(const ccaa::Corners&)>& obstructed,
         Patch& patch,
         ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
