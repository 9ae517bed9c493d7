// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of a coarse patch are flipped where it runs through
// itself.

#pragma once

#include "filling/patch.h"
#include "mesh/corners.h"
#include "run/run_control.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::repair {

/** \brief Flip edges of triangles that run into something: as long as fewer pairs of
 * triangles meet, or as many, and the patch is less bent.
 *
 * Minimum weight looks at chords alone, so the filling of a long winding hole may fold
 * over itself. Cost: linear in the patch for each edge of what runs into something.
 * \param[in] crossing triangles of the patch that run into something, ascending
 * \param[in] obstructed whether a triangle runs into other surface
 * \param[in] control once it says stop the patch is worth nothing */
void
flipCrossings(const IncompleteModel& model,
              std::vector<std::size_t> crossing,
              const std::function<bool(const ccaa::Corners&)>& obstructed,
              Patch& patch,
              ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
