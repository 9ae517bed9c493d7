// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the most distant of many points, found through a tree.

#pragma once

#include "boundary/boundary_loop.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A binary tree over points, each node in a box along its own main directions.
 *
 * Boxes along the axes would not do: seen from across a circle, all of the far arc is
 * about equally far, and the corner of such a box sticks out by more than the distances
 * differ. Along its chord the box of an arc is as thin as the arc, so a search opens
 * few nodes, however fine the curve. Cost: building n log n. */
class FarthestTree {
public:
  /** \brief The points must stay where they are. */
  explicit FarthestTree(const Positions& points);

  /** \brief Index of the point most distant from a place, the lowest of equals.
   * \param[in] guess a point that is far: the better, the faster */
  std::size_t
  farthest(const Position& place, std::size_t guess) const;

private:
  struct Node {
    Position center = Position::Zero();
    std::array<Direction, 3> axes;
    std::array<double, 3> half_sizes;
    std::size_t begin = 0; /**< in order_ */
    std::size_t end = 0;
    std::size_t lowest = 0; /**< index of a point */
    std::size_t right = 0;  /**< second child, the first one follows; 0: a leaf */
  };
  struct Search {
    Position place;
    std::size_t index;
    double sqr_distance;
  };

  std::size_t
  build(std::size_t begin, std::size_t end);
  void
  fitBox(Node& node) const;
  std::size_t
  split(const Node& node);
  static double
  boundOf(const Node& node, const Position& place);
  void
  descend(std::size_t index, double bound, Search& search) const;
  void
  lookAtLeaf(const Node& node, Search& search) const;

  const Positions& points_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl::repair
