// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how straight force lines between two caps of a sphere run.

#pragma once

#include <iosfwd>

namespace bench {

/** \brief Trace a line from every source of one rim to the other for several samplings
 * and gaps, and print how many arrive, how far they drift aside and what they cost. */
void
printLineTable(std::ostream& out);

} // namespace bench
