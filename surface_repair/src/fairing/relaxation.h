// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: moves the new vertices of a patch to a smooth surface.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "filling/patch.h"

#include <cstddef>

namespace pcl::repair {

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
 * outlier makes no spike \param[in] control once it says stop the patch is worth
 * nothing
 * \param[in] noise standard deviation of the free points, where the patch has grown
 * over them: it is drawn by them from the first round on; 0: not known, units of the
 * cloud */
RelaxationReport
relaxPatch(const IncompleteModel& model,
           const Positions& free_points,
           const RelaxationParameters& parameters,
           Patch& patch,
           ccaa::RunControl* control = nullptr,
           double noise = 0.0);

} // namespace pcl::repair
