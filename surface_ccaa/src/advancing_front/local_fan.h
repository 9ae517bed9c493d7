// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the angular order of the triangles around an open point.
#pragma once

#include "advancing_front/growing_surface.h"

namespace pcl::ccaa {

/** \brief Whether a new sector at a vertex finds its place between the fans that are
 * there, in the tangent plane of the vertex (after Gopi and Krishnan 2002).
 *
 * The fans and the sector are projected along the mean normal of the triangles at the
 * vertex and the new one. Seen from outside a fan covers the directions
 * counter-clockwise from its outgoing front edge to its incoming one; the sector must
 * not cover any of them, up to a tolerance of 0.1 rad that bent fans need.
 *
 * \param[in] vertex where
 * \param[in] from first other corner of the new triangle, counter-clockwise
 * \param[in] to second other corner
 * \param[in] normal unit normal of the new triangle */
bool
fitsFans(const GrowingSurface& surface,
         pcl::index_t vertex,
         pcl::index_t from,
         pcl::index_t to,
         const Position& normal);

} // namespace pcl::ccaa
