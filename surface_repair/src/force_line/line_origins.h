// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from which places of the boundaries lines begin
// (4.41, 4.5).

#pragma once

#include "force_line/force_line_tracker.h"
#include "force_line/normal_search.h"
#include "mesh/block_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A place on a boundary and what the field does there. */
struct PossibleOrigin {
  LineOrigin origin;
  OriginForce force;
  double gap = 0.0; /**< distance to the nearest target, units of the cloud */
};

/** \brief How far the field looks. */
struct Reach {
  double near = 0.0;          /**< L_1; 0: the spacing of the source's curve */
  double far = 0.0;           /**< L_2; 0: room times the gap at the place */
  double room = DEFAULT_ROOM; /**< gaps that L_2 spans */
  double exponent = 2.5;      /**< chi */
};

/** \brief L_1, L_2 and chi at a place with a gap before it, over sources at a spacing.
 * L_2 is at least four spacings: a boundary nearer than that is single sources. */
Falloff
falloffOver(double gap, double source_spacing, const Reach& reach);

/** \brief Step ICM3 -> ICM2: every source as the origin of a line to other islands. Its
 * own island is silent there (4.7). Places without another island are left out.
 * \param[in] targets curves of the field's sources, in their order */
std::vector<PossibleOrigin>
originsBetweenIslands(const IndicatorField& field,
                      const BoundaryEdges& targets,
                      const Reach& reach,
                      const ccaa::LoopContext& context);

/** \brief Step ICM2 -> ICM1: every source of a hole as the origin of a line across the
 * hole, with effective charges (4.5).
 * \param[in] curve of the hole, in the field and in the targets
 * \param[in] threshold T, arc length: no line ends nearer to its origin than that */
std::vector<PossibleOrigin>
originsInHole(const IndicatorField& field,
              const BoundaryEdges& targets,
              std::size_t curve,
              double threshold,
              const Reach& reach,
              const ccaa::LoopContext& context);

/** \brief Indices of the attracted origins with the highest |f|, strongest first, no
 * two of a curve nearer to each other along it than \a apart gaps of the stronger one,
 * nor than two spacings of the sources. */
std::vector<std::size_t>
strongestOrigins(const std::vector<PossibleOrigin>& origins,
                 const BoundaryEdges& targets,
                 double apart);

} // namespace pcl::repair
