// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the triangles around open points, for crossing tests.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/box_tree.h"
#include "mesh/intersection.h"
#include "mesh/point_chains.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <vector>

namespace pcl::ccaa {

/** \brief The given triangles that a new triangle between open points could cross,
 * although they touch no open point: another sheet close by, or what an outlier lies
 * behind.
 *
 * Chosen by a grid of cells around the open points, which takes a few nanoseconds a
 * triangle; only what is chosen goes into a tree. Memory: 32 bytes for each of these,
 * 64 while it is built. The same for any number of threads. */
class NearbyTriangles {
public:
  /** \param[in] triangles all given ones; looked at as long as this object lives
   * \param[in] alive one flag each; a triangle that dies later is no longer met
   * \param[in] points of the vertices
   * \param[in] open vertices
   * \param[in] cell size of the cells in units of the cloud: at least the longest edge
   * that may be made
   * \param[in] threads number of threads, at least 1 */
  NearbyTriangles(const Triangles& triangles,
                  const AliveFlags& alive,
                  const PointView& points,
                  const std::vector<pcl::index_t>& open,
                  double cell,
                  int threads = 1);

  /** \brief Whether a triangle meets one of them elsewhere than in common corners and
   * edges.
   * \param[in] ignored triangles that are not to be met, ascending */
  bool
  meets(const Corners& corners, const std::vector<pcl::index_t>& ignored) const;

  /** \brief The live ones with a watched corner that meet another live one elsewhere
   * than in common corners and edges, ascending. Cost: about 1 us for each with such a
   * corner. \param[in] watched vertices \param[in] vertices how many there are
   * \return nothing of use after cancelling */
  std::vector<pcl::index_t>
  crossingAt(const std::vector<pcl::index_t>& watched,
             std::size_t vertices,
             const LoopContext& context) const;

  std::size_t
  size() const
  {
    return chosen_.size();
  }

private:
  void
  choose(const std::vector<pcl::index_t>& open,
         double cell,
         const LoopContext& context);
  bool
  isInOrder() const;
  void
  sortAlongCurve(int threads);
  bool
  isAlive(pcl::index_t triangle) const
  {
    return alive_[static_cast<std::size_t>(triangle)] != 0;
  }
  Corners
  cornersAt(std::size_t place) const
  {
    return cornersOf(triangles_[static_cast<std::size_t>(chosen_[place])], points_);
  }

  const Triangles& triangles_;
  const AliveFlags& alive_;
  PointView points_;
  std::vector<pcl::index_t> chosen_;
  BoxTree tree_; /**< of the chosen ones */
};

} // namespace pcl::ccaa
