// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the Laplacian of a triangle mesh.

#pragma once

#include <Eigen/SparseCore>

#include "mesh/triangle.h"

#include <vector>

namespace pcl::repair {

using SparseMatrix = Eigen::SparseMatrix<double>;

/** \brief Cotangent weights and Voronoi areas (Meyer et al. 2003): row i of `stiffness`
 * times the positions, over mass[i], is the Laplacian of the position at vertex i, the
 * mean curvature normal (kappa1 + kappa2) n pointing to the hollow side. */
struct SurfaceLaplacian {
  SparseMatrix stiffness; /**< symmetric, rows add up to 0 */
  Eigen::VectorXd mass;   /**< above 0 */
};

/** \brief Cotangents are bounded (to angles of a degree or two) and areas kept from
 * vanishing, so that slivers do not rule. Cost: linear. */
SurfaceLaplacian
surfaceLaplacian(const ccaa::Triangles& triangles, const ccaa::Positions& positions);

/** \brief Unit normals by the triangles' areas; zero where there is none. */
std::vector<Eigen::Vector3d>
areaNormals(const ccaa::Triangles& triangles, const ccaa::Positions& positions);

} // namespace pcl::repair
