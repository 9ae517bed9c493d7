// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what sparse free points of lost parts do.
#pragma once

#include <iosfwd>

namespace bench {

/** \brief Lost parts of which a twentieth of the vertices is left, exact and noisy: how
 * near the new surface comes to these and to what was lost, and what they cost. */
void
printFreePointTable(std::ostream& out);

} // namespace bench
