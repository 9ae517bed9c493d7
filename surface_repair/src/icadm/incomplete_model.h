// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the incomplete normalised CAD model (D1.3-1) as read.

#pragma once

#include <pcl/surface_repair/model_findings.h>
#include <pcl/memory.h>
#include <pcl/pcl_base.h>
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include "mesh/islands.h"
#include "mesh/side_hints.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::repair {

using ccaa::Triangle;
using ccaa::Triangles;

/** \brief One connected component of the reconstructed region A. */
struct Island {
  pcl::index_t first_triangle = 0; /**< lowest triangle index */
  std::size_t triangles = 0;
  double area = 0.0;       /**< squared units of the cloud */
  Eigen::AlignedBox3d box; /**< of its vertices */
  bool closed = false;     /**< no boundary at all */
  bool one_sided = false;  /**< cannot be wound consistently: reported and left alone */
  bool is_fin = false;     /**< hangs on surface that is whole: see markFins() */
};

/** \brief A model of class ICM1, ICM2 or ICM3: a manifold of islands, all windings of
 * an island alike, and free points.
 *
 * Vertices are the points that carry a triangle, numbered by first appearance in the
 * triangles; point_of_vertex leads back to the cloud. A point with several fans has a
 * vertex for each, those beside the first after all others. Positions are double
 * precision in the units of the cloud, and in its frame less the global shift.
 */
struct IncompleteModel {
  Positions positions; /**< of the vertices */
  std::vector<pcl::index_t> point_of_vertex;
  Triangles triangles;
  ccaa::TriangleAdjacency adjacency; /**< of these triangles */
  ccaa::Islands island_of;           /**< of a triangle */
  std::vector<Island> islands;       /**< numbered by lowest triangle */
  Directions normals;    /**< external, of the vertices on boundaries, by the windings
                              (angle-weighted); zero of others: see externalNormals() */
  Positions free_points; /**< finite points without a triangle, in cloud order, then
                              those of the separate cloud; none at
                              the place of a vertex */
  std::vector<pcl::index_t> point_of_free_point; /**< cloud index; UNAVAILABLE for one
                                                      of the separate cloud */
  Positions given_normals; /**< of the vertices, as the cloud has them; else empty */
  Positions viewpoints;    /**< sensor positions of the vertices; else empty */
  /** \brief Who tells the viewpoints: TOLD_VIEWPOINT, VIEWPOINT or ORIGIN. */
  ccaa::OutwardRule viewpoints_by = ccaa::OutwardRule::VIEWPOINT;
};

} // namespace pcl::repair
