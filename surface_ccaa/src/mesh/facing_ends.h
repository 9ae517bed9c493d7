// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ends of a surface that face each other.
#pragma once

#include "mesh/contacts.h"

namespace pcl::ccaa {

/** \brief Where two stems end within a spacing of each other: around a vertex the
 * triangles within three edges are a disc from which a tube goes on, and within the
 * mean length of its edges lies such a vertex of another disc, each ahead of the other.
 * No sampling tells there whether they are one stem that was cut through. Cost: some
 * 0.1 us a vertex, and 10 us for each whose angles lack half a radian to a plane and
 * that is next to another one. \param[in] adjacency of the triangles, which are wound
 * outward \return a vertex of each, by the first */
std::vector<Contact>
facingEnds(const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const PointView& points,
           const LoopContext& context);

} // namespace pcl::ccaa
