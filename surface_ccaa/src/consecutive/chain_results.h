// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is made of a chain's mesh and times at the end.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PolygonMesh.h>

#include "mesh/block_loop.h"
#include "mesh/triangle.h"

namespace pcl::ccaa {

/** \brief Normals of a surface, see vertexNormals().
 * \param[in] triangles with corners in range
 * \param[in,out] normals as many as the cloud has points */
void
fillNormals(const Triangles& triangles,
            const PCLPointCloud2& cloud,
            const LoopContext& context,
            PointCloud<Normal>& normals);

/** \brief The figures of thesis 3.1; zeros when the run has failed.
 * \param[in] base_seconds t_A
 * \param[in] report of the chain on the same cloud */
SpeedupReport
compareSpeed(double base_seconds, const ConsecutiveReport& report);

} // namespace pcl::ccaa
