// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: brings a mesh that is no ICADM there, cut at its faults.

#pragma once

#include <pcl/PCLPointCloud2.h>

#include "icadm/model_reading.h"
#include "mesh/block_loop.h"
#include "mesh/polygon_access.h"

namespace pcl::repair {

/** \brief Make a manifold of a mesh, wound alike within each island that has two sides.
 *
 * All triangles stay but those that are there already and twists (ccaa::findTwists());
 * further vertices of a point come after all others. The side of most given windings of
 * an island stays where they agree 60 to 40 or better, others are wound outward by what
 * the cloud knows: which side is outside is for the orientation room to say.
 * \param[in,out] mesh the sound triangles of a mesh
 * \param[in,out] adjacency of these
 * \param[in] cloud of the mesh
 * \param[out] report what was done; a problem where this failed */
void
bringToManifold(ccaa::PolygonTriangles& mesh,
                ccaa::TriangleAdjacency& adjacency,
                const pcl::PCLPointCloud2& cloud,
                const ccaa::LoopContext& context,
                ReadingReport& report);

/** \brief An entry of a cloud for each vertex; none where the cloud has none. */
Positions
entriesOf(const ccaa::PointView& view,
          const std::vector<pcl::index_t>& point_of_vertex);

} // namespace pcl::repair
