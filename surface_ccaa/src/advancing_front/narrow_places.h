// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a completed mesh is thin or narrow.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/surface_completion.h"
#include "mesh/block_loop.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief The triangles at flagged vertices, ascending. */
std::vector<pcl::index_t>
trianglesAt(const std::vector<std::uint8_t>& flags, const Triangles& triangles);

/** \brief Flags all corners of the triangles at flagged vertices, so many times. */
void
addRings(int count, const Triangles& triangles, std::vector<std::uint8_t>& flags);

/** \brief Flags for the ends of edges whose ends face away from each other.
 *
 * There a start algorithm may connect two sides through the body. Such a tunnel has a
 * perfect umbrella at each point, and its edges are no sharper than those in which the
 * body ends: nothing here tells the one from the other.
 *
 * \param[in] least_rise of such an edge out of the tangent plane at an end, as a share
 * of its length: below it a triangle that is folded back onto others has turned the
 * normals of a smooth surface */
std::vector<std::uint8_t>
thinPlaces(const Triangles& triangles,
           const PointView& points,
           double least_rise,
           const LoopContext& context);

/** \brief Flags for a vertex of each small handle of a mesh whose necks are told. */
std::vector<std::uint8_t>
smallHandles(const CompletedMesh& mesh, std::size_t vertex_count);

/** \brief Tell where a completed mesh is narrow or next to itself. \param[in,out] mesh
 * whose thin necks are told gets its clefts \param[in,out] report gets all necks and
 * pieces that touch */
void
findNecks(const PointView& points,
          int threads,
          CompletedMesh& mesh,
          CompletionReport& report);

} // namespace pcl::ccaa
