// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch of which parts run into something is filled anew
// there.

#pragma once

#include "region/region.h"

namespace pcl::repair {

/** \brief Take out what of a patch runs through the surface or through the patch
 * itself, and close what is left open between the rest of the patch and the surface, in
 * wider and wider surroundings: inner vertices of the patch take part, where the rim's
 * alone leave no way around. \param[in] place of the patch; it is not mended within it
 * \param[in,out] patch without free points as vertices; what is filled anew is of the
 * hole in which it runs into something
 * \return whether it is free now, with as many handles as before; else it
 * stays as it is */
bool
mendPatch(const ClosingPlace& place,
          const SurfaceObstacle& obstacle,
          const ccaa::LoopContext& context,
          Patch& patch);

} // namespace pcl::repair
