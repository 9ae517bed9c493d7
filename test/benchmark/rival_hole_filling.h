// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: CGAL's hole filling as a rival, where CGAL is installed.
#pragma once

#include "mesh/triangle.h"

#include <vector>

namespace bench {

/** \brief What closes a hole. Corners below the number of the model's vertices are
 * these, the others are `added`. */
struct HoleFilling {
  pcl::ccaa::Triangles triangles;
  pcl::ccaa::Positions added;
  double seconds = 0;
};

/** \brief Whether this program was built with CGAL; without it all fillings are empty.
 */
bool
hasHoleFilling();

/** \brief CGAL's triangulation of a hole without new vertices.
 * \param[in] loop vertices of the hole in the direction that new triangles have */
HoleFilling
triangulateHole(const pcl::ccaa::Positions& positions,
                const std::vector<pcl::index_t>& loop);

/** \brief CGAL's triangulate_refine_and_fair_hole(), with its default settings, on a
 * manifold. \param[in] loop as above */
HoleFilling
refineAndFairHole(const pcl::ccaa::Triangles& triangles,
                  const pcl::ccaa::Positions& positions,
                  const std::vector<pcl::index_t>& loop);

} // namespace bench
