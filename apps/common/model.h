// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a cloud or mesh file holds.
#pragma once

#include <pcl/PolygonMesh.h>

#include <Eigen/Geometry>

#include "status.h"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/** \brief Where the sensor stood, if the file says so. */
struct Viewpoint {
  bool known = false;
  Eigen::Vector3f position = Eigen::Vector3f::Zero(); /**< in the units of the cloud */
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};

/** \brief Contents of a file: a cloud with all its fields (x, y and z always float32)
 * and, for a mesh, polygons whose indices have been checked. */
struct Model {
  pcl::PolygonMesh mesh;
  Viewpoint viewpoint;
  Warnings warnings; /**< what the file holds that the model does not */
};

/** \brief A whole number for every polygon of a mesh, such as its provenance. */
struct FaceProperty {
  std::string name;
  std::vector<std::int32_t> values;
};

} // namespace app
