// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that are in the way of another one.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "repair/growing_surface.h"
#include "repair/opening.h"
#include "repair/passes.h"
#include "repair/region_closing.h"
#include "survey/model_survey.h"

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

/** \brief Close holes that could not be closed because a patch would run through
 * something, together with new triangles around them: what is in the way is mostly
 * another patch that was made before, without knowledge of this one.
 *
 * Each is opened wider and wider, one ring of new triangles after the other; where that
 * leads to nothing all stays as it was. Cost: of a hole some fillings (closeRegion()).
 * \param[in] failed holes by a vertex of theirs, as a pass left them
 */
void
reopenHoles(const Failures& failed, const Course& course);

} // namespace pcl::repair
