// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what given normals and sensor positions say about sides.

#pragma once

#include "icadm/incomplete_model.h"
#include "orientation/side_votes.h"

#include <vector>

namespace pcl {
namespace repair {

/** \brief Votes of the given normals, by the area a triangle has across the mean normal
 * of its corners. Normals that are not finite or zero do not vote. One entry an island;
 * without votes where there are no normals. */
std::vector<SideVotes>
votesOfNormals(const IncompleteModel& model);

/** \brief Votes of a direction in which the outer side looks, by the area across it. */
std::vector<SideVotes>
votesOfUp(const IncompleteModel& model, const Direction& up);

/** \brief Votes of the sensor positions, by the area a triangle shows to the sensor of
 * its first corner. */
std::vector<SideVotes>
votesOfViewpoints(const IncompleteModel& model);

} // namespace repair
} // namespace pcl
