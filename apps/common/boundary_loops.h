// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how many holes and rims a mesh has.
#pragma once

#include <pcl/Vertices.h>

#include <cstddef>
#include <vector>

namespace app {

/** \brief Number of boundary loops of a manifold mesh of triangles. Linear, and several
 * times cheaper than pcl::ccaa::measureMesh(), which knows everything about any mesh.
 */
std::size_t
countBoundaryLoops(const std::vector<pcl::Vertices>& triangles,
                   std::size_t point_count,
                   int threads);

} // namespace app
