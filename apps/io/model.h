// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a cloud or mesh file holds.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
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
  bool may_be_origin = false; /**< the file says the origin, which it also does when it
                                   knows no better */
  bool is_origin = false;     /**< that was believed */
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); /**< in the frame of the cloud */
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();

  /** \brief Whether there is more to it than what files have that know none. */
  bool
  isTold() const
  {
    return is_origin || !position.isZero(0) ||
           !orientation.coeffs().isApprox(Eigen::Quaternionf::Identity().coeffs(), 0);
  }
};

/** \brief Text of a file that is for people; units are often there. */
struct Remarks {
  std::vector<std::string> comments; /**< lines without their keyword or sign */
  std::vector<std::string> infos;    /**< the obj_info lines of PLY */
  std::string title;                 /**< of a VTK file; empty where it tells nothing */
};

/** \brief Contents of a file: a cloud with all its fields (x, y and z all float32, or
 * all double where the file has more digits than that) and, for a mesh, polygons whose
 * indices have been checked. */
struct Model {
  pcl::PolygonMesh mesh;
  pcl::GlobalShift shift; /**< taken off the positions wherever floats are worked on */
  Viewpoint viewpoint;
  Remarks remarks;
  Warnings warnings; /**< what the file holds that the model does not */
};

/** \brief A whole number for every polygon of a mesh, such as its provenance. */
struct FaceProperty {
  std::string name;
  std::vector<std::int32_t> values;
};

/** \brief What a file gets besides points and polygons, as far as its format can. */
struct FileExtras {
  std::vector<FaceProperty> properties;
  Viewpoint viewpoint;
  Remarks remarks;
};

} // namespace app
