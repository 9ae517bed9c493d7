// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points at which holes meet, as one vertex while these holes
// are closed.

#pragma once

#include "icadm/incomplete_model.h"
#include "mesh/block_loop.h"

#include <map>
#include <vector>

namespace pcl::repair {

/** \brief Which vertex takes the place of a vertex. */
using VertexMap = std::map<pcl::index_t, pcl::index_t>;

/** \brief Vertices with a point that an earlier vertex has: two fans of it may not be
 * one vertex of the mesh. \param[in] point_of the point of each vertex, or UNAVAILABLE
 */
std::vector<bool>
copiesOfPoints(const std::vector<pcl::index_t>& point_of);

/** \brief Let the fans of a point share a vertex where holes meet in it. Until these
 * are closed the model is no manifold there, and replaced vertices have no triangle.
 * \param[in] replaced what pinchedVertices() found */
void
weldPinches(const VertexMap& replaced,
            const ccaa::LoopContext& context,
            IncompleteModel& model);

/** \brief Slits beside new triangles: two edges, one after the other on a boundary,
 * from one vertex of a point to another one of the same point. Nothing is missing
 * there; these vertices have to become one. \param[in] added new triangles, none of
 * them in the model's adjacency \return the higher vertex with the lower one */
VertexMap
slitsBetween(const IncompleteModel& model, const Triangles& added);

/** \brief Take out the vertices that were replaced, and give each fan of a point a
 * vertex of its own again where holes stayed open: the first keeps that which is there.
 * \param[in,out] model of which positions, points, viewpoints, triangles and adjacency
 * are brought up to date, nothing else \return for each vertex there was its number
 * now, UNAVAILABLE where it is taken out
 */
std::vector<pcl::index_t>
separatePinches(const ccaa::LoopContext& context, IncompleteModel& model);

} // namespace pcl::repair
