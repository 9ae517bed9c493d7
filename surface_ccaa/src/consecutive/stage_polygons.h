// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: taking over the polygons that any algorithm hands out.
#pragma once

#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/types.h>
#include <pcl/Vertices.h>

#include "mesh/block_loop.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Whether all polygons have three different corners below `point_count`. */
bool
areTriangles(const std::vector<pcl::Vertices>& polygons,
             std::size_t point_count,
             const LoopContext& context);

/** \brief Leave out polygons with a corner out of range or twice the same corner, and
 * turn those with more than three corners into fans around their first one.
 * \return how many were left out */
std::size_t
makeTriangles(std::vector<pcl::Vertices>& polygons,
              std::size_t point_count,
              const LoopContext& context);

/** \brief Replace positions in a selection by the cloud indices selected. Positions out
 * of range become -1. */
void
mapToCloud(const pcl::Indices& selection, std::vector<pcl::Vertices>& polygons);

/** \brief Triangles as the rooms see them, without renumbering. */
Triangles
toIndexTriangles(const std::vector<pcl::Vertices>& polygons,
                 const LoopContext& context);

/** \brief The role of each point in any mesh of triangles. A point with more than one
 * fan counts as boundary. For who did not filter with UmbrellaFilter, which knows. */
std::vector<PointRole>
findPointRoles(const std::vector<pcl::Vertices>& polygons,
               std::size_t point_count,
               const LoopContext& context);

} // namespace pcl::ccaa
