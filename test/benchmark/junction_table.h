// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how well junctions are told, and the weights behind it.

#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief Find junctions in generated damages of closed bodies and in generated range
 * maps of several objects, whose truth is known; fit the weights of their evidence to
 * the scenes of even seeds, and print these and how often the verdicts of the library
 * are right on those of odd seeds. */
void
printJunctionTable(std::ostream& out, std::uint64_t seeds);

} // namespace bench
