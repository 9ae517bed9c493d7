// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which sides of pieces look the same way across a gap.
#pragma once

#include "mesh/winding.h"
#include "tiles/seam.h"

namespace pcl::ccaa {

/** \brief Turn pieces so that the triangles that one tile has made lie as it wound
 * them: it knew more of the surface than a seam does. Each piece is told by the tile of
 * which it has most. \param[in] pieces of the triangles \param[in,out] given the
 * triangles of the seam, each piece wound alike */
void
turnAsMade(const Seam& seam, const Winding& pieces, Triangles& given);

/** \brief Turn pieces whose triangles at open points show their other side to the
 * nearest ones of other pieces, the clearest pairs of pieces first. Cost: n log n.
 * \param[in] pieces of the triangles \param[in,out] given the triangles of the seam,
 * each piece wound alike \return whether any was turned */
bool
turnToFace(const Seam& seam, const Winding& pieces, Triangles& given);

} // namespace pcl::ccaa
