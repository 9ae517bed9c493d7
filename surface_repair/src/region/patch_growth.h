// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the coarse patch of a region grows over its samples.

#pragma once

#include "region/patch_fairing.h"

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

/** \brief Fair a patch that has grown over samples. Those with noise draw it, instead
 * of being its vertices, so that it averages them.
 *
 * They are held where they are exact, where little tells noise from detail, and with a
 * trust near 1; and after all where the patch that they draw runs into something, or is
 * farther from them than their noise lets it: what was smoothed away is no noise. */
FairedPatch
fairGrown(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          PatchFairing how,
          const ccaa::LoopContext& context,
          Patch& patch);

} // namespace pcl::repair
