// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what kind of surface triangles make.
#pragma once

#include <pcl/surface_ccaa/surface_topology.h>

#include "mesh/block_loop.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

namespace pcl::ccaa {

/** \brief What kind of surface the triangles make. Cost: linear, about 0.05 us a
 * triangle. \param[in] adjacency of these triangles */
SurfaceTopology
topologyOf(const Triangles& triangles, const TriangleAdjacency& adjacency);

/** \brief The same where the edge-connected pieces are counted already. */
SurfaceTopology
topologyOf(const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           std::size_t pieces,
           const LoopContext& context);

} // namespace pcl::ccaa
