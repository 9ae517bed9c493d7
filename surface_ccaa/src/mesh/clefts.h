// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a surface faces itself across hardly any space.
#pragma once

#include "mesh/thin_necks.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Flags for the vertices in clefts: at the bottom of a groove so sharp or so
 * narrow that within three rings of triangles around a concave edge its two sides face
 * each other, their normals more than 120 degrees apart; with one ring more. In such a
 * groove two bodies meet that come closer to each other than their points lie apart.
 * Cost: some 5 us for each edge, in noise.
 *
 * \param[in] bottoms concave edges (findSharpEdges())
 * \param[in] adjacency of the triangles, which are wound alike, outward */
std::vector<std::uint8_t>
cleftVertices(const std::vector<TriangleAdjacency::Edge>& bottoms,
              const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const PointView& points,
              const LoopContext& context);

/** \brief Where a surface is narrow between two parts of it: thin necks, and each cleft
 * around which it goes on to two sides that nothing else connects, and that are far
 * larger than a disc which would close it (see neckParts()). There two bodies may
 * have come out as one. Cost: that of neckParts().
 * \param[in] thin what thinNecks() has found; handles among them do not count
 * \param[in] is_cleft of cleftVertices()
 * \return a vertex of each, ascending */
std::vector<pcl::index_t>
neckVertices(const std::vector<ThinNeck>& thin,
             const std::vector<std::uint8_t>& is_cleft,
             const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const PointView& points,
             int threads = 1);

} // namespace pcl::ccaa
