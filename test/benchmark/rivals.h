// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the field offers, for comparison in the same run.
#pragma once

#include <pcl/PolygonMesh.h>

#include "input_clouds.h"

namespace bench {

/** \brief PCL's greedy projection triangulation, normal estimation included. The radius
 * is given in mean distances to the sixth neighbor. */
pcl::PolygonMesh
greedyProjection(const Cloud::Ptr& cloud, double spacing, double radius);

/** \brief Mean distance to the sixth neighbor, over a sample of the points. */
double
spacingOf(const Cloud::Ptr& cloud);

/** \brief Whether this program was built with CGAL. */
bool
hasAdvancingFront();

/** \brief CGAL's advancing front surface reconstruction, all defaults; number of
 * triangles (0 without CGAL). */
std::size_t
advancingFront(const Cloud& cloud);

} // namespace bench
