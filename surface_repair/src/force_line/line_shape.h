// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is done to a force line once it has been traced.

#pragma once

#include "force_line/force_line.h"

#include <vector>

namespace pcl::repair {

/** \brief Interpolate the normals over the points where the field left them open, by
 * arc length between the normals before and after (4.44). */
void
completeNormals(ForceLine& line, const std::vector<bool>& undetermined);

/** \brief Mean |f| along the line, by trapezoids (4.41). */
double
meanTension(const ForceLine& line);

} // namespace pcl::repair
