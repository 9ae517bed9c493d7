// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether a boundary is a jump in depth of one sensor's view.

#pragma once

#include "boundary/boundary_loop.h"

#include <vector>

namespace pcl::repair {

/** \brief A surface across a closed curve, as a sensor sees it from far away. */
struct FillArea {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero(); /**< sum of the area normals */
  double size = 0.0; /**< of the surface, in the same units: twice the area */
};

/** \brief What is known of it before there is one: the least that it can have. */
FillArea
fillAreaOf(const BoundaryCurve& curve);

/** \brief Whether a surface across a closed curve would lie along the rays of the one
 * sensor that has measured its vertices: the gap between an object's silhouette and
 * what stands behind it. False where several sensors have measured them, or none, and
 * where all lies within a few edge lengths of depth. Cost: some hundred triangles for
 * each vertex.
 * \param[in] vertices of the points; those beyond the model's have no sensor */
bool
isDepthJump(const FillArea& fill,
            const BoundaryCurve& curve,
            const std::vector<pcl::index_t>& vertices,
            const IncompleteModel& model);

/** \brief Whether the one sensor that has measured a loop sees its surface within it:
 * the outline of what it sees, and no hole. False where several sensors have measured
 * it, or none, and where the loop is too thin in its view to tell. Cost linear. */
bool
isOutline(const BoundaryCurve& curve,
          const std::vector<pcl::index_t>& vertices,
          const IncompleteModel& model);

} // namespace pcl::repair
