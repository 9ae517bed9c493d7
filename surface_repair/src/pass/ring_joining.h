// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins two boundaries all around at once.

#pragma once

#include "pass/passes.h"

namespace pcl::repair {

/** \brief Boundaries that bridges join, by a vertex of each, where a pass has failed
 * all around both. The likeliest junctions come first. */
std::vector<VertexPair>
failedPairs(const ModelSurvey& survey, const Failures& failed);

/** \brief Close the ring between two boundaries where bridges connect nothing else and
 * what they leave could not be filled, each hole by itself, without running into
 * something: as a whole, by minimum weight, the ring has more ways.
 * \param[in] pass what the last one closed is part of the model
 * \return whether any ring was closed, and is part of the model */
bool
joinRings(const ClosedHoles& pass, const Course& course);

} // namespace pcl::repair
