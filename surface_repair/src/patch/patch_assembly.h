// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fillings of neighbouring holes as one patch.

#pragma once

#include "filling/filling_method.h"
#include "filling/patch.h"
#include "hole/hole_polygon.h"
#include "junction/depth_jump.h"

#include <cstddef>
#include <set>
#include <vector>

namespace pcl::repair {

/** \brief A hole, or a part of one that was divided, with its filling. */
struct FilledPart {
  HolePolygon polygon;
  Filling filling;      /**< its free points as in the model */
  std::size_t hole = 0; /**< which one it is of */
};

/** \brief Add what fills a part. */
void
addFill(const FilledPart& part, FillArea& fill);

/** \brief Put fillings together; parts meet at the vertices that they share.
 * \param[in] model_vertices number of vertices of the model */
Patch
assemblePatch(const std::vector<FilledPart>& parts,
              std::size_t model_vertices,
              const CreaseVertices& creases = {});

/** \brief The patch without the triangles of some holes, and without the vertices that
 * only these have. */
Patch
withoutHoles(const Patch& patch, const std::set<std::size_t>& holes);

/** \brief Bring new vertices to the nearest places that floats can hold: what is tested
 * is what will be written. \param[in] origin of the patch, in the frame of the floats
 */
void
roundToFloats(const Position& origin, Patch& patch);

/** \brief Whether model and patch together are a manifold, wound alike, at all vertices
 * of the patch; but for several fans at a point that has several in the model. */
bool
fitsModel(const IncompleteModel& model, const Patch& patch);

} // namespace pcl::repair
