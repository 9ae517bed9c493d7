// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: free points pull a traced line to themselves (4.6).

#pragma once

#include <pcl/surface_repair/field/free_point_field.h>
#include <pcl/surface_repair/force_line/force_line.h>

namespace pcl {
namespace repair {

/** \brief How far free points pull a line. */
struct PerturbationParameters {
  /** \brief k_t of the free points, in [0, 1): 0 leaves the line where it is. */
  double trust = 0.5;
  /** \brief Half height of the cylinder around the normal line, in R_2, above 0: free
   * points further off the line are those of another sheet. Default 1. */
  double half_height = 1.0;
  /** \brief k of E4.6-4: weight of the supporting points, at least 0. Default 1. */
  double support_weight = 1.0;
  /** \brief Weight of the pole that the unperturbed point itself is, at least 0.
   * Default 1, the tension of a free point of trust 0.5. With 0 (E4.6-3 to the letter)
   * one free point, however little trusted and however far aside within R_2, pulls the
   * line all the way. */
  double own_weight = 1.0;
};

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

} // namespace repair
} // namespace pcl
