// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of the mesh facts that needs no positions.
#pragma once

#include "mesh/mesh_facts.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Fill in all counts of vertices, edges, components and loops. facts.vertices
 * must be set; lengths of loops are measured with positions. */
void
measureTopology(const Triangles& valid_triangles,
                const PointView& positions,
                MeshFacts& facts);

} // namespace pcl::ccaa
