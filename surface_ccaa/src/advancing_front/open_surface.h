// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a cloud and its partial mesh still to be done.
#pragma once

#include "advancing_front/tuning.h"
#include "greedy/ranked_points.h"
#include "mesh/index_set.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief What the base algorithm works on: the open points (free points and boundary
 * points) and the triangles that touch them, the \e rim.
 *
 * Vertices are numbered anew: first the open points, then the other corners of the rim.
 * All that is closed already is left out, so that the work depends on what is missing
 * and not on the size of the cloud. */
struct OpenSurface {
  Positions positions;         /**< of all vertices */
  std::size_t open_points = 0; /**< vertices [0, open_points) */
  Triangles rim;               /**< each edge has two triangles at most, which agree */
  std::vector<index_t> neighbor_table; /**< of the open points among themselves */
  NeighborRows neighbors;              /**< the same as rows, nearest first */
  /** \brief Distance between samples around each open point; 0 where it is not known
   * yet (see completeSpacings()). */
  std::vector<double> spacings;
  double largest_room =
      tuning::LARGEST_ROOM; /**< see PartialSurface::setLargestRoom() */
  /** \brief Given triangles that count as taken away, by their numbers in the whole,
   * ascending. */
  std::vector<index_t> removed;
  Positions normals; /**< outward, of the open points, zero where unknown; or empty */
  Positions outward; /**< where the surface looks at the open points, by normals or by
                          whatever else is known; zero where unknown; or empty */
};

/** \brief Number the vertices of an open surface: the open ones, then the other corners
 * of its rim, ascending.
 * \param[in,out] rim in the vertices of the whole, then in these numbers
 * \param[in,out] vertices the open ones; the others are put behind them
 * \return the numbers of all of them */
IndexSet
numberRim(Triangles& rim, std::vector<index_t>& vertices);

/** \brief Triangles of an open surface in the vertices of the whole.
 * \param[in] vertices what its vertices are there */
Triangles
inTheWhole(Triangles triangles, const std::vector<index_t>& vertices);

/** \brief Fill the neighbor table by comparing all with all: for small open surfaces.
 * Rows ascend by distance, then by number. Cost O(n^2 log n). */
void
findNeighborsDirectly(OpenSurface& open, unsigned int k);

} // namespace pcl::ccaa
