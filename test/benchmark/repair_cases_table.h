// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how many repairs come out right.
#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief The cases of the tests over seeds: how many come out right, and what goes
 * wrong in the others. */
void
printRepairCases(std::ostream& out, std::uint64_t seeds);

/** \brief Random damage over seeds: how often a repair fails, loses a triangle, makes
 * what is no manifold or lets the surface run through itself, and the slowest. */
void
printRepairFuzz(std::ostream& out, std::uint64_t seeds);

} // namespace bench
