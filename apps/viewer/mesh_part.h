// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a part of a model, cut out as a mesh of its own.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include <Eigen/Geometry>

#include "icadm/incomplete_model.h"

#include <vector>

namespace app {

/** \brief Some triangles of a model. Points have doubles as coordinates, in the model's
 * frame, and normals by which the part is wound as the model is. */
struct MeshPart {
  pcl::PolygonMesh mesh;
  pcl::PCLPointCloud2 free_points;    /**< those of the model that belong to it */
  std::vector<pcl::index_t> point_of; /**< of the cloud of the whole; ascending */

  /** \brief The point of the part that is this point of the whole, which it has. */
  pcl::index_t
  pointFor(pcl::index_t point) const;
};

/** \brief All triangles with a corner in a box, in order, and the free points in it.
 * Cost: a look at each vertex, triangle and free point of the model. */
MeshPart
cutPart(const pcl::repair::IncompleteModel& model, const Eigen::AlignedBox3d& box);

} // namespace app
