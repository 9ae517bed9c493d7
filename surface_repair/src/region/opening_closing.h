// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an opening is closed as a hole of its own.

#pragma once

#include "patch/opening.h"
#include "region/region.h"

namespace pcl::repair {

/** \brief How an opening may be closed. */
struct ClosedOpening {
  HoleOutcome outcome;     /**< still open where there is no way */
  Replacement replacement; /**< where there is one */
};

/** \brief How an opening of a surface may be closed as a hole of its own, together with
 * the hole that it was grown from.
 * \param[in] part of the surface that has the opening
 * \param[in] around beyond which nothing is known */
ClosedOpening
closeOpening(const Opening& opening,
             const ModelPart& part,
             const ccaa::Box& around,
             const RepairParameters& parameters,
             const CloudFrame& frame,
             const ccaa::LoopContext& context,
             const GrowingSurface& surface);

} // namespace pcl::repair
