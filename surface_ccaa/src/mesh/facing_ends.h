// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ends of a surface that face each other.
#pragma once

#include "mesh/contacts.h"

namespace pcl::ccaa {

/** \brief Where two stems end within a spacing of each other: around a vertex the
 * triangles within three edges are a disc from which a tube goes on, and within the
 * mean length of its edges lies such a vertex of another disc, each ahead of the other.
 * No sampling tells there whether they are one stem that was cut through. Cost: some
 * 0.3 us for each edge, and 10 us for each vertex there whose angles lack half a radian
 * to a plane and that is next to another one.
 *
 * \param[in] ridges convex edges at which ends are looked for (findSharpEdges())
 * \param[in] adjacency of the triangles, which are wound alike, outward
 * \return a vertex of each, by the first */
std::vector<Contact>
facingEnds(const std::vector<TriangleAdjacency::Edge>& ridges,
           const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const PointView& points);

} // namespace pcl::ccaa
