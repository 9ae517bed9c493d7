// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes that bridges connect are closed together.

#pragma once

#include "patch/surface_obstacle.h"
#include "region/region.h"

#include <vector>

namespace pcl::repair {

/** \brief Divide, fill, refine and relax, and try again in other ways where the result
 * would run through something; what cannot be closed is left out. Nothing is kept that
 * does not fit the model or that meets the obstacle. \param[in] without_samples how
 * its holes fail if it has none, where that is known; else null */
ClosedRegion
closeRegion(const ClosingPlace& place,
            const Region& region,
            const SurfaceObstacle& obstacle,
            const ccaa::LoopContext& context,
            const std::vector<HoleOutcome>* without_samples = nullptr);

} // namespace pcl::repair
