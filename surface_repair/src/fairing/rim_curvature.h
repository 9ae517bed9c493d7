// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how strongly the model is bent where a patch joins it.

#pragma once

#include "fairing/joined_surface.h"

#include <vector>

namespace pcl::repair {

/** \brief The sum of the principal curvatures at the vertices of a patch's rim, above 0
 * where the model bulges out, in 1 / size of the joined surface.
 *
 * Steiner's formula: the integral over an area is the sum of length times dihedral
 * angle of the edges within. Averaged over the model's rings that the surface has, so
 * that the noise of a scan, which adds up to nothing, cancels. What is then not between
 * 0 and twice the median along the rim is brought there: sharp edges do not go on. */
std::vector<double>
rimCurvatures(const JoinedSurface& surface, std::size_t rim);

} // namespace pcl::repair
