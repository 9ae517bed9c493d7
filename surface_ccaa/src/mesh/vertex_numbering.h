// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: numbering vertices by their first appearance.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Replace the point indices in triangles by vertex numbers: the first point
 * that appears becomes 0, the next new one 1, and so on. \return the point of each
 * vertex; the same for any number of threads */
std::vector<pcl::index_t>
numberVertices(std::size_t point_count,
               const LoopContext& context,
               Triangles& triangles);

} // namespace pcl::ccaa
