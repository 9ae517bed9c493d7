// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: methods whose meshes may have points of their own.
#pragma once

#include "method_inputs.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

/** \brief A mesh, whoever made it. */
struct FreeMesh {
  pcl::ccaa::Positions positions;
  pcl::ccaa::Triangles triangles;
  double seconds = 0; /**< search and normals included */
};

/** \brief A method with its settings. */
struct FreeMethod {
  std::string name;
  std::function<FreeMesh(const MethodInput&)> run;
};

/** \brief Ours (as it is, after cleaning, and repaired), and what PCL and, where they
 * are there, CGAL and Open3D have. Normals are PCL's, of 12 neighbours, and turned
 * outward by the truth: more than they can have in practice. */
std::vector<FreeMethod>
freeMethods();

} // namespace bench
