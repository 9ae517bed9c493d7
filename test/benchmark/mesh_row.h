// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes side by side, for one picture.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/Vertices.h>

#include <Eigen/Geometry>

#include "mesh/triangle.h"

#include <string>
#include <vector>

namespace bench {

/** \brief Meshes side by side, turned to the viewer, each in the place of the first. */
class MeshRow {
public:
  /** \brief Begin with points.
   * \param[in] view direction from the object to the viewer
   * \param[in] triangles of these points; none: a cloud */
  MeshRow(const pcl::ccaa::Position& view,
          const pcl::ccaa::Positions& positions,
          const pcl::ccaa::Triangles& triangles = {});

  void
  add(const pcl::ccaa::Positions& positions, const pcl::ccaa::Triangles& triangles);

  /** \brief As PLY; throws std::runtime_error if that fails. */
  void
  write(const std::string& file) const;

private:
  Eigen::Quaterniond turn_;
  Eigen::AlignedBox3d box_; /**< of the first, turned */
  pcl::PointCloud<pcl::PointXYZ> cloud_;
  std::vector<pcl::Vertices> polygons_;
  int places_ = 0;
};

} // namespace bench
