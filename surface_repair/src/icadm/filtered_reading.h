// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: brings a mesh that is no ICADM there, windings kept.

#pragma once

#include <pcl/surface_ccaa/mesh/block_loop.h>
#include <pcl/surface_ccaa/mesh/polygon_access.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/PolygonMesh.h>

#include <cstddef>

namespace pcl {
namespace repair {

struct FilteredTriangles {
  ccaa::PolygonTriangles mesh;
  UmbrellaReport report;
  std::size_t reversed_triangles = 0; /**< against the input */
};

/** \brief Filter a mesh without the rule on small regions (C3.4-3).
 *
 * The filter winds every island outward by its own lights. Which side of an island is
 * outside is for the orientation room to say, so an island whose given windings mostly
 * agree (60 to 40 or better) keeps that side here.
 * \param[in] given the sound triangles of the mesh \return nothing after cancelling */
FilteredTriangles
filterTriangles(const ccaa::PolygonTriangles& given,
                const pcl::PCLPointCloud2& cloud,
                const ccaa::LoopContext& context);

} // namespace repair
} // namespace pcl
