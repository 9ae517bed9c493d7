// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the triangles around open points, for crossing tests.
#pragma once

#include "mesh/box_tree.h"
#include "mesh/intersection.h"
#include "mesh/point_chains.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief The given triangles that a new triangle between open points could cross,
 * although they touch no open point: another sheet close by, or what an outlier lies
 * behind.
 *
 * Chosen by a grid of cells around the open points, which takes a few nanoseconds a
 * triangle; only what is chosen goes into a tree. */
class NearbyTriangles {
public:
  /** \param[in] triangles all given ones; looked at as long as this object lives
   * \param[in] alive one flag each; a triangle that dies later is no longer met
   * \param[in] points of the vertices
   * \param[in] open vertices
   * \param[in] cell size of the cells in units of the cloud: at least the longest edge
   * that may be made */
  NearbyTriangles(const Triangles& triangles,
                  const AliveFlags& alive,
                  const PointView& points,
                  const std::vector<pcl::index_t>& open,
                  double cell);

  /** \brief Whether a triangle meets one of them elsewhere than in common corners and
   * edges.
   * \param[in] box around the triangle
   * \param[in] ignored triangles that are not to be met, ascending */
  bool
  meets(const Corners& corners,
        const Box& box,
        const std::vector<pcl::index_t>& ignored) const;

  std::size_t
  size() const
  {
    return chosen_.size();
  }

private:
  bool
  isLong(pcl::index_t triangle, double cell) const;

  const Triangles& triangles_;
  const AliveFlags& alive_;
  PointView points_;
  std::vector<pcl::index_t> chosen_;
  std::unique_ptr<BoxTree> tree_;
};

} // namespace ccaa
} // namespace pcl
