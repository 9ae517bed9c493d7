// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the field offers, for comparison in the same run.
#pragma once

#include "reconstruction.h"

namespace bench {

/** \brief PCL's greedy projection triangulation, normal estimation included. The radius
 * is given in mean distances to the sixth neighbor. */
Reconstruction
greedyProjection(const Cloud::Ptr& cloud, double spacing, double radius);

/** \brief Mean distance to the sixth neighbor, over a sample of the points. */
double
spacingOf(const Cloud::Ptr& cloud);

/** \brief Whether this program was built with CGAL. */
bool
hasAdvancingFront();

/** \brief CGAL's advancing front surface reconstruction, all defaults; no triangles
 * without CGAL. */
Reconstruction
advancingFront(const Cloud& cloud);

/** \brief The same for hasAdvancingFront(). */
bool
hasScaleSpace();

/** \brief CGAL's scale space reconstruction: four steps of smoothing, then triangles
 * that a ball touches from outside (alpha shape), on the points as they were; all
 * defaults. No triangles without CGAL. */
Reconstruction
scaleSpace(const Cloud& cloud);

/** \brief Whether this program was built with Open3D. */
bool
hasBallPivoting();

/** \brief Open3D's ball pivoting with balls of 0.75, 1.5 and 3 spacings, estimating and
 * orienting normals included; no triangles without Open3D.
 * \param[in] spacing mean distance to the sixth neighbor */
Reconstruction
ballPivoting(const Cloud& cloud, double spacing);

/** \brief All of them that this program was built with, each with the settings that
 * suit a cloud. Runs GP3 a few times to find its radius: the fastest of the usual ones
 * that finds nine tenths of the triangles of the best. */
std::vector<Method>
rivalsFor(const Cloud::Ptr& cloud);

} // namespace bench
