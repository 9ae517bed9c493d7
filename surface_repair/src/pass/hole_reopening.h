// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that are in the way of another one.

#pragma once

#include "pass/passes.h"

namespace pcl::repair {

/** \brief Close holes that could not be closed because a patch would run through
 * something, together with new triangles around them: what is in the way is mostly
 * another patch that was made before, without knowledge of this one.
 *
 * Each is opened wider and wider, one ring of new triangles after the other; where that
 * leads to nothing all stays as it was. Cost: of a hole some fillings (closeRegion()).
 * \param[in] failed holes by a vertex of theirs, as a pass left them
 */
void
reopenHoles(const Failures& failed, const Course& course);

} // namespace pcl::repair
