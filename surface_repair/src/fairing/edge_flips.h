// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: flips until the triangles of a patch are Delaunay-like.

#pragma once

#include "fairing/patch_edges.h"
#include "run/run_control.h"

namespace pcl::repair {

/** \brief Flip edges whose opposite angles add up to more than a half turn, where that
 * folds nothing over and the new edge is neither in the patch nor in the model.
 *
 * Ends after at most ten flips an edge; ties by number.
 * \param[in] keeps_shape only edges between triangles of one plane */
void
flipToDelaunay(const Patch& patch,
               PatchEdges& edges,
               bool keeps_shape = false,
               ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
