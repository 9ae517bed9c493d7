// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the linear system of a fair surface.

#pragma once

#include "fairing/joined_surface.h"
#include "fairing/sparse_factorisation.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A place on a triangle of the patch that something draws to itself. */
struct Pull {
  std::size_t triangle = 0;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  Position target = Position::Zero(); /**< in the frame of the joined surface */
  double weight = 0.0;                /**< at least 0, size squared / area */
};

/** \brief Which vertices move, and what their surface is to be like. */
struct FairingTask {
  std::vector<char> fixed;        /**< of all vertices of the joined surface */
  std::vector<char> hinges;       /**< of the patch's vertices: nothing bends there */
  std::vector<double> curvatures; /**< wanted, of the vertices of the patch; empty: 0 */
  std::vector<Pull> pulls;
};

/** \brief The positions x that make the integral of |Laplacian(x) + curvature n|^2
 * least, plus sum of w |x(pull) - target|^2, with metric and normals n of the surface
 * as it is.
 *
 * Without curvatures a thin plate; with them surfaces of constant mean curvature,
 * spheres and cylinders among them, are exact solutions (after Schneider and Kobbelt
 * 2001). The Laplacians at the rim count too, with the first ring of the model in them:
 * they make the tangent planes join.
 *
 * \param[in,out] solver of the rounds before, or a new one
 * \param[in,out] control told the work, may be null
 * \return of the vertices of the patch; empty where there is no finite solution, or
 * after cancelling */
Positions
fairPositions(const JoinedSurface& surface,
              const FairingTask& task,
              SparseFactorisation& solver,
              ccaa::RunControl* control);

/** \brief Values at the rim, continued over the patch without a maximum or minimum
 * within. \param[in] values of the first vertices \param[in,out] control told the work,
 * may be null \return of all of the patch; the mean of the values where that fails */
std::vector<double>
harmonicValues(const JoinedSurface& surface,
               const std::vector<double>& values,
               ccaa::RunControl* control);

} // namespace pcl::repair
