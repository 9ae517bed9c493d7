// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: loops that are the two ends of one gap.

#pragma once

#include "boundary/boundary_loop.h"
#include "run/run_control.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief For each loop the one that it looks at and that looks back at it, NONE where
 * there is none: the ends of a limb or a handle that was cut through. By their course
 * and by the size of their islands both may pass for holes, each to be closed by
 * itself.
 *
 * Most points of each loop, along their conormals, must meet the other loop before any
 * other and before their own loop's other side, no further away than a gap in a limb of
 * this girth is likely to be. Loops of one island may be opposed to each other, too.
 * Cost: some thousand operations for each pair of loops that lie near to each other.
 * \param[in,out] control told the work, may be null; after cancelling some are missing
 */
std::vector<std::size_t>
opposedLoops(const BoundaryLoops& loops, ccaa::RunControl* control = nullptr);

/** \brief The loop that a mouth of a tube looks at, whether that looks back or not, no
 * further away than a few diameters; NONE where there is none. */
std::size_t
loopAhead(const BoundaryLoops& loops, std::size_t mouth);

/** \brief Cosine from which two loops look the same way. */
constexpr double SAME_WAY = 0.5;

/** \brief Whether what would close two curves alone looks into about one direction:
 * they are no ends of one gap, but those of two limbs side by side, such as fingers.
 * \param[in] cosine between the two, least */
bool
lookTheSameWay(const BoundaryCurve& first,
               const BoundaryCurve& second,
               double cosine = SAME_WAY);

} // namespace pcl::repair
