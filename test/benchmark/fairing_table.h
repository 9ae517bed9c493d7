// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how near refined and relaxed patches come to what was lost.
#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief Cut holes into closed models, close them from the same triangulation with our
 * refinement and relaxation and with CGAL's, and print a row a hole: mean distance of
 * the lost surface from the closed hole in per cent of the model's diagonal, and the
 * seconds; below, the geometric mean of the ratios and the worst one. Says so where
 * this program was built without CGAL.
 * \param[in] places of a hole of each kind in each model */
void
printFairingTable(std::ostream& out, std::uint64_t places);

} // namespace bench
