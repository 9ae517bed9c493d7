// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch together with the model's triangles around it.

#pragma once

#include "filling/patch.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A patch and some rings of the model's triangles around, as one small mesh in
 * units of its own size, so that neither the unit nor the place of the cloud matters.
 *
 * The vertices of the patch come first, in the same order, and its triangles too. */
struct JoinedSurface {
  Positions positions; /**< (place - centre) / size */
  Triangles triangles;
  std::size_t patch_vertices = 0;
  std::size_t patch_triangles = 0;
  std::vector<char> whole;        /**< of a vertex: triangles all around it are here */
  std::vector<std::size_t> rings; /**< of a model's triangle: in which ring, from 1 */
  Position centre = Position::Zero();
  double size = 1.0; /**< diagonal of the patch's box, units of the cloud */
};

/** \brief Gather the triangles of the model that the rim can be reached from in so many
 * steps from vertex to vertex. Cost: linear in what is gathered. */
JoinedSurface
joinSurface(const IncompleteModel& model, const Patch& patch, std::size_t rings);

} // namespace pcl::repair
