// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: loops that belong together but lost their bridges.

#pragma once

#include "listing/hole_list.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Two loops of a survey. */
using LoopPair = std::pair<std::size_t, std::size_t>;

/** \brief Loops that bridges connect, those of the likeliest junctions first; bridges
 * that no contour keeps count, too. */
std::vector<LoopPair>
bridgedPairs(const SurveyedBridges& joined);

/** \brief Pairs of loops of different islands of a body whose junction is joined, but
 * whose bridges no contour keeps (C4.47-3): a single one, or some that are twisted.
 * Each pair is one hole: the ring between them, cut open over the shortest way. The
 * likeliest junctions come first, each loop has one ring, and none joins islands that
 * are joined. */
std::vector<OpenHole>
ringsOverJunctions(const ModelSurvey& survey);

} // namespace pcl::repair
