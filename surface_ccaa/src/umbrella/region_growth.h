// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: regions large enough to be trusted (condition C3.4-3).
#pragma once

#include "mesh/block_loop.h"
#include "mesh/point_chains.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief What removeSmallRegions() found. */
struct RegionReport {
  std::size_t regions_kept = 0;
  std::size_t triangles_removed = 0;
};

/** \brief Remove whole regions with fewer than N_i internal points (C3.4-3).
 *
 * A region is a set of triangles connected over edges. Every vertex must have at most
 * one chain (run eliminateChains() before): then no two regions share a vertex, regions
 * are the connected sets of vertices, and removing one leaves all others as they are,
 * so nothing has to be examined again.
 *
 * \param[in] minimum_internal_points N_i; 0 keeps every region
 * \param[in,out] alive flags of the triangles
 * \param[in,out] fans of the vertices: NONE, OPEN or CLOSED */
RegionReport
removeSmallRegions(const Triangles& triangles,
                   std::size_t minimum_internal_points,
                   const LoopContext& context,
                   AliveFlags& alive,
                   std::vector<Fan>& fans);

} // namespace pcl::ccaa
