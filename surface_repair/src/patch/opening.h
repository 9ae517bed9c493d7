// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a disc of new triangles that is to be filled anew.

#pragma once

#include "boundary/boundary_loop.h"
#include "patch/growing_surface.h"
#include "patch/surface_obstacle.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A disc of a part that is to be filled anew. */
struct Opening {
  std::vector<bool> is_open;        /**< of the part's triangles; new ones only */
  std::vector<pcl::index_t> border; /**< of the part, the surface on the left; empty
                                         where there is no such disc */
};

/** \brief Some triangles of a part, and rings of new ones around them. */
std::vector<bool>
ringsAround(const ModelPart& part, std::vector<bool> some, int rings);

/** \brief Grown from a new triangle over others that may be opened, so that it is a
 * disc all the time. */
Opening
openFrom(const ModelPart& part, std::size_t first, const std::vector<bool>& may_open);

/** \brief The same from a hole. \param[in] hole its loop, vertices of the part */
Opening
openFrom(const ModelPart& part,
         const std::vector<pcl::index_t>& hole,
         const std::vector<bool>& may_open);

/** \brief Where an opening is filled: its border with half as much room around it. */
ccaa::Box
placeOf(const ModelPart& part, const Opening& opening);

/** \brief Whether all of the border lies in a box. */
bool
isWithin(const ccaa::Box& box, const ModelPart& part, const Opening& opening);

/** \brief The loop that passes a vertex; or null. */
const BoundaryLoop*
loopAt(const BoundaryLoops& loops, pcl::index_t vertex);

/** \brief The loop that the border of an opening is in what is left of a part.
 * \return null where it touches something else in a point, or an open boundary */
const BoundaryLoop*
loopOf(const Opening& opening,
       const ModelPart& part,
       const ModelPart& left,
       const BoundaryLoops& loops);

/** \brief The triangles of a part that are not open and meet a place, as numbered in
 * the whole. */
std::vector<std::size_t>
trianglesLeft(const ModelPart& part, const Opening& opening, const ccaa::Box& place);

/** \brief Whether all of a patch lies in a place, and runs into nothing there. */
bool
isFree(const Patch& patch,
       const ccaa::Box& place,
       const SurfaceObstacle& obstacle,
       ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
