// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from votes and field integrals to sides (4.48).

#pragma once

#include "orientation/field_integrals.h"
#include "orientation/free_sight.h"
#include "orientation/island_orientation.h"

#include <vector>

namespace pcl::repair {

/** \brief All that is known about the sides of the islands, with the windings they
 * have. */
struct SideEvidence {
  std::vector<FreeSight> sight; /**< an island each */
  double sight_trust = 1.0;     /**< how much sight says of this model, 0 to 1 */
  std::vector<double> areas;    /**< of the islands */
  std::vector<PairIntegral> pairs;
};

/** \brief Decide the islands that are still UNDECIDED by the field, strongest first
 * (4.48).
 *
 * Islands that other rules have decided are the standard islands. The next one is
 * always the island with the greatest integral over its pairs with standard islands,
 * both ways round, among those where its sign is clear; it becomes a standard island
 * itself. Where none is clear, field and free sight are asked together, the sight
 * weighing as much as the share of its ways that are free: what is seen through gaps
 * errs easily. Where that says nothing either, the largest island that is left becomes
 * a standard island with the winding it has, and the free sight of all that gathers
 * around it says in the end whether the whole group is to be turned. */
void
decideByField(const SideEvidence& evidence,
              const OrientationParameters& parameters,
              std::vector<IslandSide>& sides);

} // namespace pcl::repair
