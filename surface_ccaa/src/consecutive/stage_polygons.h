// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: taking over the polygons that any algorithm hands out.
#pragma once

#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/types.h>
#include <pcl/Vertices.h>

#include "mesh/block_loop.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::ccaa {

/** \brief Polygons that are triangles, of corners below `point_count`.
 * \return nothing if one of them is not */
std::optional<Triangles>
readTriangles(const std::vector<pcl::Vertices>& polygons,
              std::size_t point_count,
              const LoopContext& context);

/** \brief Triangles of any polygons: those with a corner out of range or twice the same
 * corner are left out, those with more than three corners become fans around their
 * first one.
 *
 * \param[in] selection null: corners are cloud indices; else places in it
 * \param[out] triangles of cloud indices
 * \return how many polygons were left out */
std::size_t
makeTriangles(const std::vector<pcl::Vertices>& polygons,
              const pcl::Indices* selection,
              std::size_t point_count,
              const LoopContext& context,
              Triangles& triangles);

/** \brief The role of each point in any mesh of triangles. A point with more than one
 * fan counts as boundary. For who did not filter with UmbrellaFilter, which knows. */
std::vector<PointRole>
findPointRoles(const Triangles& triangles,
               std::size_t point_count,
               const LoopContext& context);

} // namespace pcl::ccaa
