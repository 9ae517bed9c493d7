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

/** \brief What scanners see: range maps as they are, clouds after reconstruction; in
 * one thread and in two. */
void
printScans(std::ostream& out, std::size_t repeats);

/** \brief The longest time in which a repair cannot be cancelled: scans and generated
 * holes, in one thread and in two. */
void
printGaps(std::ostream& out);

/** \brief 100 to 10 000 holes, in one thread and in two. */
void
printManyHoles(std::ostream& out, std::size_t repeats);

/** \brief One hole of some hundred to 2 000 edges. */
void
printLongHoles(std::ostream& out, std::size_t repeats);

} // namespace bench
