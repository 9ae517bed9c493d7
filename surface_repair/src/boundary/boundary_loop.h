// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a closed boundary of the reconstructed region A.

#pragma once

#include <pcl/types.h>

#include "icadm/incomplete_model.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief The geometry of a closed boundary, walked with the surface on the left: the
 * positive direction of D4.1-2, for rims and holes alike.
 *
 * Edge k runs from points[k] to points[(k + 1) % size]; normals[k] is the external unit
 * normal of the surface along that edge. The conormal m = tau x n points away from the
 * surface, into the missing area. Who has the boundary of a surface from elsewhere can
 * fill this in by hand.
 */
struct BoundaryCurve {
  Positions points;
  Directions normals; /**< one an edge */

  std::size_t
  size() const
  {
    return points.size();
  }
  std::size_t
  next(std::size_t k) const
  {
    return k + 1 == points.size() ? 0 : k + 1;
  }
  Eigen::Vector3d
  edge(std::size_t k) const
  {
    return points[next(k)] - points[k];
  }
};

/** \brief Length of all edges. */
double
lengthOf(const BoundaryCurve& curve);

/** \brief A boundary loop of a model. */
struct BoundaryLoop {
  std::size_t island = NONE;
  std::vector<pcl::index_t> vertices;  /**< of the model, in positive direction */
  std::vector<pcl::index_t> triangles; /**< the triangle of each edge */
  BoundaryCurve curve;                 /**< of these vertices */
  double length = 0.0;                 /**< units of the cloud */
};

/** \brief The lowest point of the cloud that some vertices have; UNAVAILABLE where
 * none has one. */
pcl::index_t
lowestPoint(const IncompleteModel& model, const std::vector<pcl::index_t>& vertices);

using BoundaryLoops = std::vector<BoundaryLoop>;

} // namespace pcl::repair
