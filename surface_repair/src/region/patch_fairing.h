// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch refined and relaxed as far as it runs into nothing.

#pragma once

#include "region/region.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief How a patch is faired. */
struct PatchFairing {
  bool is_flat = false;     /**< in the plane of its rim, rather than relaxed */
  bool keeps_shape = false; /**< see FillStrategy; only a patch that is free as it is */
  double noise = 0.0;       /**< of samples that draw a patch grown over them, see
                                 relaxPatch() */
};

/** \brief What came of a patch. */
struct FairedPatch {
  std::vector<std::size_t> obstructed; /**< triangles that run into something in the
                                            patch as it would be written, ascending */
  bool is_faired = true; /**< it was free before, if its shape was to be kept */
};

/** \brief Refine and relax a patch; where it runs into something then, it goes back to
 * what it was before it was relaxed, in wider and wider surroundings.
 */
FairedPatch
fairPatch(const ClosingPlace& place,
          const SurfaceObstacle& obstacle,
          const PatchFairing& how,
          const ccaa::LoopContext& context,
          Patch& patch);

} // namespace pcl::repair
