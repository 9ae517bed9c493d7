// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: surfaces that meet in an edge, taken apart.

#pragma once

#include "icadm/incomplete_model.h"
#include "icadm/point_fans.h"

namespace pcl::repair {

/** \brief Which triangles go on over edges of three and more: pairs of them, each a
 * sheet, and the others end there.
 *
 * The best pair is taken first: of triangles that have a neighbour elsewhere (others
 * are flaps, fins and membranes), then of those that are wound alike (each connected
 * part as most of it is), then of those that are least bent against each other, then of
 * those that bulge outward, so that two bodies which touch along an edge become two; a
 * tie goes to the lowest triangles. No pair makes a part one-sided. At an edge of more
 * than 32 triangles no sheet can be told, and all of them end there. Cost: linear, and
 * the pairs at these edges.
 * \return the neighbour over each of these edges, from all triangles on them */
ChangedEdges
pairSheets(const Triangles& triangles,
           const ccaa::TriangleAdjacency& adjacency,
           const Positions& positions);

/** \brief Cut a mesh where it is no manifold, and only there: each sheet and each fan
 * gets vertices of its own, so that all triangles stay. Where a sheet comes to one edge
 * twice, it is also cut along further edges beside it.
 * \param[in] triangles none of them twice */
PointFans
cutAtFaults(const Triangles& triangles,
            const ccaa::TriangleAdjacency& adjacency,
            const Positions& positions);

} // namespace pcl::repair
