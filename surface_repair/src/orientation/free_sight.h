// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island the enclosing sphere sees (4.48).

#pragma once

#include "icadm/incomplete_model.h"
#include "mesh/block_loop.h"
#include "mesh/side_votes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::repair {

/** \brief What ways to the enclosing sphere tell about an island. */
struct FreeSight {
  ccaa::SideVotes votes; /**< free ways on the winding's side against the other side */
  double asked = 0.0;    /**< weight of all ways tried on one side */

  /** \brief Share of the ways that are free on the better side, 0 to 1. */
  double
  share() const
  {
    return asked > 0.0 ? 0.5 * (votes.total + std::abs(votes.sum)) / asked : 0.0;
  }

  /** \brief How much the votes count beside the field, 0 to 1: where less than a
   * quarter of the ways is free, they lead through gaps of the model, as often from the
   * inner side as from the outer one. */
  double
  weight() const
  {
    return std::clamp(2.0 * share() - 0.5, 0.0, 1.0);
  }
};

/** \brief Look from points of every island to the sphere around the model.
 *
 * The thesis looks along the half-line from the centre; here every point looks in many
 * directions on both of its sides, so that islands in a recess are decided too. A way
 * is free when it meets no surface and passes no free point closer than \a clearance.
 * Points are spread evenly over the area of the island, directions evenly over the half
 * sphere; a way weighs the cosine of its angle to the normal. The choice of both is
 * fixed, so the result is the same at every run and for any number of threads.
 *
 * Cost: about 1000 ways an island, fewer for more than 200 islands. */
std::vector<FreeSight>
lookAround(const IncompleteModel& model,
           double clearance,
           const ccaa::LoopContext& context);

} // namespace pcl::repair
