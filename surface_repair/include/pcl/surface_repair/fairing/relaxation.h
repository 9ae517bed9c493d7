// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: moves the new vertices of a patch to a smooth surface.

#pragma once

#include <pcl/surface_repair/darning/patch.h>

#include <cstddef>

namespace pcl {
namespace repair {

/** \brief How new vertices move to a smooth surface. */
struct RelaxationParameters {
  /** \brief k_t of the free points, in [0, 1): 0 and they do not count.
   * Default 0.5. */
  double trust = 0.5;
  /** \brief Free points count within so many edge lengths of the patch, above 0.
   * Default 3. */
  double reach = 3.0;
  /** \brief Times that the surface is solved anew on what came out before, at least 1;
   * fewer are done where one would make the surface worse, or has changed next to
   * nothing. Default 6. */
  std::size_t rounds = 6;
};

/** \brief What relaxPatch() did. */
struct RelaxationReport {
  bool solved = false;         /**< if not, the patch is as it was */
  std::size_t free_points = 0; /**< that had a say */
  double largest_move = 0.0;   /**< of a vertex, units of the cloud */
};

/** \brief Move the vertices that are not held to a surface that joins the model with
 * its tangent planes (C1), as smooth as can be, drawn by the free points.
 *
 * Nothing else changes. The same for any number of threads; cost n^1.5 in the number of
 * vertices. \param[in] free_points finite, near the patch or elsewhere; a single
 * outlier makes no spike */
RelaxationReport
relaxPatch(const IncompleteModel& model,
           const Positions& free_points,
           const RelaxationParameters& parameters,
           Patch& patch);

} // namespace repair
} // namespace pcl
