// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair costs.
#pragma once

#include <cstddef>
#include <iosfwd>

namespace bench {

/** \brief Table T4.8-1 of the thesis on the Bunny and a woman's body, both modes. */
void
printThesisTable(std::ostream& out, std::size_t repeats);

/** \brief Time against the length of all boundaries: more and more damage to one model.
 */
void
printRepairGrowth(std::ostream& out, std::size_t repeats);

/** \brief Ten holes in 5 million triangles, beside reading the mesh's adjacency. */
void
printLargeRepair(std::ostream& out, std::size_t repeats);

} // namespace bench
