// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PCL polygons to index triangles and back.
#pragma once

#include <pcl/surface_ccaa/impl/triangle_handoff.h>
#include <pcl/Vertices.h>

#include "mesh/block_loop.h"
#include "mesh/mesh_view.h"
#include "mesh/point_chains.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief The sound triangles of a list of polygons.
 *
 * Vertices are numbered by their first appearance in the triangles: polygons mostly
 * come in an order that is coherent in space, points often do not, and all that follows
 * is several times faster when neighbours lie close in memory. */
struct PolygonTriangles {
  Triangles triangles;                       /**< in the order of the polygons */
  std::vector<pcl::index_t> point_of_vertex; /**< point index of each vertex */
  std::size_t invalid_polygons = 0;          /**< left out */
};

/** \brief Read polygons; those with more than three corners become fans around their
 * first corner.
 *
 * A polygon is left out and counted as invalid when it has fewer than three corners,
 * a corner that is no index of `points`, the same corner twice, or a corner that is not
 * finite. Cost: linear; 24 bytes a triangle, 4 a vertex, for a while 4 more a point.
 * \return nothing of use after cancelling */
PolygonTriangles
readPolygons(const PolygonView& polygons,
             const PointView& points,
             const LoopContext& context);

/** \brief Polygons as fans around their first corner, with nothing looked at: what is
 * wrong with a polygon shows as an invalid triangle, or as none with fewer than three
 * corners. */
Triangles
fanTriangles(const PolygonView& polygons);

/** \brief Write triangles as polygons, in their order. Buffers of polygons that are
 * there already are used again. */
void
writePolygons(const Triangles& triangles,
              const LoopContext& context,
              std::vector<pcl::Vertices>& polygons);

/** \brief Let triangles of vertices be triangles of points. */
void
renumber(const std::vector<pcl::index_t>& point_of_vertex,
         const LoopContext& context,
         Triangles& triangles);

/** \brief Give triangles to whom a run was asked by: as they are, or as polygons.
 * \param[in] handoff null: as polygons
 * \param[out] polygons empty where there is a handoff */
void
handOut(Triangles triangles,
        const std::vector<pcl::index_t>& point_of_vertex,
        const LoopContext& context,
        TriangleHandoff* handoff,
        std::vector<pcl::Vertices>& polygons);

/** \brief Only the triangles that are alive, in their order. */
Triangles
liveTriangles(const Triangles& triangles,
              const AliveFlags& alive,
              const LoopContext& context);

} // namespace pcl::ccaa
