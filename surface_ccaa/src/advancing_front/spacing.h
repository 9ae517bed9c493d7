// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far apart the samples lie around open points.
#pragma once

#include "advancing_front/open_surface.h"
#include "advancing_front/partial_surface.h"
#include "mesh/point_view.h"

#include <vector>

namespace pcl::ccaa {

/** \brief Root mean square distance of an open point to its six nearest open points; 0
 * where it has no neighbor. In units of the cloud. */
double
spacingFromNeighbors(const OpenSurface& open, pcl::index_t point);

/** \brief Complete the spacings of an open surface.
 *
 * Known ones (see PartialSurface::openAt()) are the mean length of the shorter half of
 * a point's given edges: the edges along a hole are long because of the hole; the
 * shorter half tells what the sampling was meant to be. The others come from the
 * neighbors. Where closed parts of the surface close by have edges more than twice as
 * long, the sampling is uneven by itself, and half of that length counts. */
void
completeSpacings(OpenSurface& open);

/** \brief Median length of the given edges, of every so many; 0 without any. */
double
usualSpacing(const Triangles& given, const PointView& points);

/** \brief Largest distance from samples inside a gap that is closed, in spacings, by
 * the room that the given triangles leave: the radius of the smallest circle around
 * one. Points that lie at random leave wider gaps than those of a grid, and these are
 * no holes. Of every so many triangles. */
double
largestRoom(const PartialSurface& surface,
            const Triangles& given,
            const PointView& points);

/** \brief Size of the cells of NearbyTriangles: several times the typical distance of
 * an open point from the sixth of its neighbors, which new edges seldom exceed.
 * \param[in] usual spacing, for where no point is open */
double
cellSize(const OpenSurface& open, double usual);

} // namespace pcl::ccaa
