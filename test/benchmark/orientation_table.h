// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how often the outer side of islands is found.

#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief Cut closed models into islands by slabs and rings of several widths, turn
 * islands at random, orient them, and print a row a model and a kind of damage with the
 * islands that came out right, wrong and undecided.
 * \param[in] rounds of damage for each row */
void
printOrientationTable(std::ostream& out, std::uint64_t rounds);

} // namespace bench
