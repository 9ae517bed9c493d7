// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an opening is closed as a hole of its own.

#pragma once

#include "patch/opening.h"
#include "region/region.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Take an opening out of a surface and close it as a hole of its own, together
 * with the hole that it was grown from.
 * \param[in] part of the surface that has the opening
 * \param[in] around beyond which nothing is known
 * \param[in] of_hole that new triangles close
 * \return how; still open where there is no way, and then the surface is as it was */
HoleOutcome
closeOpening(const Opening& opening,
             const ModelPart& part,
             const ccaa::Box& around,
             const RepairParameters& parameters,
             const CloudFrame& frame,
             const ccaa::LoopContext& context,
             std::size_t of_hole,
             GrowingSurface& surface);

} // namespace pcl::repair
