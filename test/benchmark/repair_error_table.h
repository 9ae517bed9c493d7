// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how near the repaired surface comes to the lost one.
#pragma once

#include <cstddef>
#include <iosfwd>

namespace bench {

/** \brief The Bunny cut by five slabs, without and with free points. */
void
printRepairedBunny(std::ostream& out, std::size_t repeats);

/** \brief A sphere in four pieces with small gaps, over seeds. */
void
printRepairedSphere(std::ostream& out);

/** \brief One large hole in curved surfaces, beside CGAL's refine-and-fair. */
void
printCurvedHoles(std::ostream& out, std::size_t repeats);

} // namespace bench
