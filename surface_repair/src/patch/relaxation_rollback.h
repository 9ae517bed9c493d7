// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: takes back relaxation where it runs into something.

#pragma once

#include "patch/surface_obstacle.h"

#include <vector>

namespace pcl::repair {

/** \brief Bring the vertices of some triangles of a patch, and those around them, back
 * to where they were before it was relaxed; further away they go back the less the more
 * edges are between.
 * \param[in] before positions of all vertices, held ones included
 * \param[in] triangles of the patch \param[in] rings edges around their vertices within
 * which vertices go back all the way */
void
rollBackRelaxation(const Positions& before,
                   const std::vector<std::size_t>& triangles,
                   std::size_t rings,
                   Patch& patch);

} // namespace pcl::repair
