// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans that touch in one point, taken apart.

#pragma once

#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <map>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief A triangle and a corner of it (0 to 2): the edge from there to the next one.
 */
using TriangleEdge = std::pair<pcl::index_t, int>;

/** \brief Edges over which a triangle has another neighbour than the adjacency says;
 * TriangleAdjacency::NONE: it has none. In ascending order. */
using ChangedEdges = std::map<TriangleEdge, pcl::index_t>;

/** \brief Triangles of which no two fans share a vertex. */
struct PointFans {
  ccaa::Triangles triangles;
  std::vector<pcl::index_t> vertices; /**< of the new vertices, which follow those that
                                           are there: which one each was */
};

/** \brief Give each fan at a vertex but the first, the one with the lowest triangle, a
 * vertex of its own.
 * \param[in] changed where the fans end or go on in another way than the adjacency
 * says; overfull edges that are not in it end them */
PointFans
separateFans(const ccaa::Triangles& triangles,
             const ccaa::TriangleAdjacency& adjacency,
             const ChangedEdges& changed = {});

} // namespace pcl::repair
