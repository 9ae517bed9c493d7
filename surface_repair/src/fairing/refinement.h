// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: new vertices until a patch is as dense as what is around.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "filling/patch.h"
#include "run/run_control.h"

namespace pcl::repair {

/** \brief Split and flip edges until their lengths follow those of the model around
 * (Liepa 2003): the sizing field at a vertex of the rim is the mean length of the
 * model's edges there, within the patch it is interpolated.
 *
 * Edges on the border of the patch stay. No edge between two vertices of the rim is
 * left within the patch if the model has that edge too. New vertices are appended;
 * those that were there keep their numbers and places; a triangle keeps its hole (one
 * of a flipped pair, either of theirs).
 * \param[in] keeps_shape the surface stays the same set of points: what is free of
 * others stays free \param[in] control once it says stop the patch is worth nothing */
void
refinePatch(const IncompleteModel& model,
            const RefinementParameters& parameters,
            Patch& patch,
            bool keeps_shape = false,
            ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
