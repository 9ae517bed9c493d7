// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole as a closed polygon of vertices, ready to be filled.

#pragma once

#include "boundary/boundary_loop.h"
#include "hole/hole_contour.h"

#include <cstddef>
#include <map>
#include <vector>

namespace pcl::repair {

/** \brief The closed contour of one hole, the surface on the left. Its points are
 * vertices of the model, and new ones on bridges. */
struct HolePolygon {
  BoundaryCurve curve; /**< normals: external, of the surface or the bridge along each
                            edge */
  std::vector<pcl::index_t> vertices; /**< one a point: below the number of the model's
                                           vertices one of these, from there on a new
                                           one */
  std::size_t second_loop = 0;        /**< see FillingTask */

  std::size_t
  size() const
  {
    return vertices.size();
  }
};

/** \brief The vertices that contours run over. */
struct ContourVertices {
  std::vector<std::vector<pcl::index_t>> of_curve; /**< model vertices of the points */
  std::vector<pcl::index_t> first_inner; /**< of each bridge: number of the vertex that
                                              its second point is; the others follow */
};

/** \brief The crease that vertices lie on, by its number: bridges that are creases,
 * ends included. */
using CreaseVertices = std::map<pcl::index_t, std::size_t>;

/** \brief The polygon of a contour whose supporting points are all vertices (see
 * supportedByVertices()). */
HolePolygon
polygonOf(const HoleContour& contour,
          const BoundaryEdges& boundaries,
          const std::vector<Bridge>& bridges,
          const ContourVertices& vertices);

/** \brief The polygon of a boundary loop. */
HolePolygon
polygonOf(const BoundaryLoop& loop);

} // namespace pcl::repair
