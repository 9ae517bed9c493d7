// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the regions of a pass, side by side.

#pragma once

#include "pass/region_memory.h"
#include "region/region.h"

#include <functional>
#include <vector>

namespace pcl::repair {

/** \brief Close regions (closeRegion()), as one after the other, so that each sees the
 * patches that came before it; in as many threads as there are, as what is tried ahead
 * of its turn is tried again if a patch has come where it looked. The same for any
 * number of threads.
 * \param[in,out] memory of what could not be closed before
 * \param[in] tell is called with the share that is done */
std::vector<ClosedRegion>
closeRegions(const ClosingPlace& place,
             const std::vector<Region>& regions,
             const ccaa::LoopContext& context,
             RegionMemory& memory,
             const std::function<void(double)>& tell);

} // namespace pcl::repair
