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

/** \brief Fair a patch that has grown over samples with noise: they draw it, instead of
 * being its vertices, so that it averages them.
 *
 * With exact samples, where little tells noise from detail, and with a trust near 1
 * they are to be held: not done. Nor is it kept where it runs into something, or is
 * farther from the samples than their noise lets it: what was smoothed away is no
 * noise. \param[in,out] patch grown; as it was where nothing is returned */
std::optional<FairedPatch>
fairDrawn(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          const PatchFairing& how,
          const ccaa::LoopContext& context,
          Patch& patch);

} // namespace pcl::repair
