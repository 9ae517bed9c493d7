// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a normal for each vertex of a mesh.
#pragma once

#include <Eigen/Core>

#include "mesh/block_loop.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <vector>

namespace pcl::ccaa {

/** \brief The unit normal of each vertex: the mean of the normals of its triangles,
 * each weighted by the angle it has at the vertex (Thuermer and Wuethrich 1998). So it
 * does not depend on how the surface around the vertex is cut into triangles.
 *
 * The side is that of the windings. A vertex gets NaN when it has no triangle of an
 * area above zero, or when its triangles cancel out. The result is the same for any
 * number of threads.
 *
 * Cost: linear, about 0.15 us a triangle on one thread; 24 bytes a triangle while it
 * runs.
 * \param[in] triangles corners below positions.size(); of any mesh
 * \param[in] positions of the vertices; triangles with a non-finite corner do not count
 * \return one a vertex; of no use after cancelling */
std::vector<Eigen::Vector3f>
vertexNormals(const Triangles& triangles,
              const PointView& positions,
              const LoopContext& context);

} // namespace pcl::ccaa
