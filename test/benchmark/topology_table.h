// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how often damaged models get their topology back.
#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief Closed models that lose 5, 15 and 40 % of their triangles in patches, balls
 * and slabs, over seeds: how many come out right, or wrong without a word, with and
 * without a twentieth of the lost vertices as free points, beside CGAL's advancing
 * front on the points that are left and its filling of each loop. */
void
printTopologyTable(std::ostream& out, std::uint64_t seeds);

} // namespace bench
