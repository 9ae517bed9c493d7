// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins two boundaries all around at once.

#pragma once

#include "repair/passes.h"

namespace pcl::repair {

/** \brief Close the ring between two boundaries where bridges connect nothing else and
 * what they leave could not be filled, each hole by itself, without running into
 * something: as a whole, by minimum weight, the ring has more ways.
 * \param[in] failed of the last pass, which has closed nothing
 * \return whether any was closed, and is part of the model */
bool
joinRings(const Failures& failed, const Course& course);

} // namespace pcl::repair
