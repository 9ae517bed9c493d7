// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which sides of pieces look the same way across a gap.
#pragma once

#include "mesh/winding.h"
#include "tiles/seam.h"

namespace pcl::ccaa {

/** \brief Turn pieces whose triangles at open points show their other side to the
 * nearest ones of other pieces, the clearest pairs of pieces first. Cost: n log n.
 * \param[in] pieces of the triangles \param[in,out] given the triangles of the seam,
 * each piece wound alike \return whether any was turned */
bool
turnToFace(const Seam& seam, const Winding& pieces, Triangles& given);

} // namespace pcl::ccaa
