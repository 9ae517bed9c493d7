// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: free points pull a traced line to themselves (4.6).

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "field/free_point_field.h"
#include "force_line/force_line.h"

namespace pcl::repair {

/** \brief The displacement of one point of a line along its normal, before tapering
 * (E4.6-1 to E4.6-4): poles are the projections, onto the normal line, of the free
 * points within the cylinder and of the supporting points.
 * \return signed, units of the cloud; 0 where there is no free point */
double
displacementAt(const ForceLine& line,
               std::size_t point,
               const FreePointField& free_points,
               const PerturbationParameters& parameters);

/** \brief The line with its points moved along their normals.
 *
 * The displacement is tapered to 0 over R_2 (at most half the line) at both ends, so
 * that C4.6-1 holds exactly: the first and the last point keep their bits. Normals
 * follow the new direction; length is measured anew, tensions and quality stay those of
 * the field. The line should have points at distances of about the source spacing (see
 * resampled()). Cost: one radius search a point. */
ForceLine
perturbed(const ForceLine& line,
          const FreePointField& free_points,
          const PerturbationParameters& parameters = {});

} // namespace pcl::repair
