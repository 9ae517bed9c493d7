// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what follows from the triangles of an incomplete model.

#pragma once

#include "icadm/incomplete_model.h"
#include "mesh/block_loop.h"

namespace pcl::repair {

/** \brief A model of triangles that are one already: adjacency, islands and normals
 * follow from them; there are no free points and vertex k is point k of the cloud.
 *
 * Cost: about 0.5 us a triangle on one thread.
 * \param[in] triangles a manifold, wound alike within each island that has two sides
 * \param[in] positions of the vertices, finite, each with a triangle
 * \return of no use after cancelling */
IncompleteModel
assembleModel(Triangles triangles,
              Positions positions,
              const ccaa::LoopContext& context);

/** \brief The same with an adjacency of these triangles that is there already. */
IncompleteModel
assembleModel(Triangles triangles,
              Positions positions,
              ccaa::TriangleAdjacency adjacency,
              const ccaa::LoopContext& context);

/** \brief Bring the adjacency of a model up to date with its triangles and positions.
 */
void
rebuildAdjacency(const ccaa::LoopContext& context, IncompleteModel& model);

/** \brief Every used vertex has one fan and no edge more than two triangles (D1.3-1).
 */
bool
isManifold(const ccaa::TriangleAdjacency& adjacency);

/** \brief Whether two vertices of a model are the ends of an edge. */
bool
areJoined(const IncompleteModel& model, pcl::index_t a, pcl::index_t b);

/** \brief No edge is run through twice in the same direction. */
bool
isConsistentlyWound(const Triangles& triangles,
                    const ccaa::TriangleAdjacency& adjacency);

/** \brief External unit normals of all vertices by the windings, weighted by angle; NaN
 * where the triangles have no area. To be called again after windings changed. */
Directions
externalNormals(const Triangles& triangles,
                const Positions& positions,
                const ccaa::LoopContext& context);

} // namespace pcl::repair
