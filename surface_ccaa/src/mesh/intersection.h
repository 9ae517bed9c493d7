// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: exact answers to what meets what in a mesh.
#pragma once

#include "mesh/corners.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "run/run_control.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Whether three points lie on one line (or in one place). Exact. */
bool
isCollinear(const Corners& triangle);

/** \brief Whether the closed segment p q and the closed triangle have a point in
 * common; touching counts. Exact for finite coordinates; the triangle must not be
 * collinear. */
bool
segmentMeetsTriangle(const Position& p, const Position& q, const Corners& triangle);

/** \brief Whether two triangles of a mesh meet where they should not. Exact for finite
 * coordinates; the triangles must not be collinear. Corners at exactly the same place
 * are the same corner:
 * - no common corner: they meet when they have a point in common;
 * - one: when the far edge of one of them meets the other triangle;
 * - two: when they fold onto each other (coplanar, on the same side of the edge);
 * - three: always. */
bool
trianglesMeet(const Corners& first, const Corners& second);

/** \brief The same of triangles that may be collinear: these meet nothing. */
inline bool
areasMeet(const Corners& first, const Corners& second)
{
  return !isCollinear(first) && !isCollinear(second) && trianglesMeet(first, second);
}

/** \brief Indices of two triangles, the lower one first. */
using TrianglePair = std::pair<pcl::index_t, pcl::index_t>;

/** \brief What findSelfIntersections() found. */
struct SelfIntersections {
  std::vector<TrianglePair> pairs; /**< ascending */
  std::size_t left_out =
      0;                  /**< triangles not tested: collinear, non-finite or invalid */
  bool cancelled = false; /**< stopped: pairs is empty */
};

/** \brief All pairs of triangles that meet where they should not (see trianglesMeet()).
 *
 * The result does not depend on the number of threads. Cost: about 2 us a triangle on
 * one thread for a mesh that hardly intersects itself; 150 bytes a triangle.
 *
 * \param[in] triangles any; an index out of range or repeated leaves a triangle out
 * \param[in] positions of the vertices
 * \param[in] threads at least 1
 * \param[in,out] control stage "self-intersections" */
SelfIntersections
findSelfIntersections(const Triangles& triangles,
                      const PointView& positions,
                      int threads,
                      RunControl& control);

} // namespace pcl::ccaa
