// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the coarse patch of a region grows over its samples.

#pragma once

#include "region/region.h"

namespace pcl::repair {

/** \brief Make the samples of a region vertices of its coarse patch, which is freed of
 * what runs into something before: by flips, then by filling anew there. Not where it
 * has a handle: it is wrong as a whole then.
 *
 * \param[in,out] patch of the fills; worth nothing once the context is cancelled
 * \return whether the samples tell a surface, rather than being stray points */
bool
growPatch(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          const ccaa::LoopContext& context,
          Patch& patch);

} // namespace pcl::repair
