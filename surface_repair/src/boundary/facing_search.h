// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether a rim looks at the boundary of another island.

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A binary tree over points of all boundaries, searched along a view.
 *
 * A point sees another island ahead when some boundary point of that island lies within
 * VIEW_ANGLE of the conormal and looks back. Loops much shorter than the one that looks
 * do not count: fragments in front of a border are not what lies beyond it. Cost: some
 * hundred points of a loop are taken, 1 to 10 us each. */
class FacingSearch {
public:
  explicit FacingSearch(const BoundaryLoops& loops);

  /** \brief Share of a loop's points that see another island ahead, 0 to 1. */
  double
  facedShare(std::size_t loop) const;

private:
  struct BoundaryPoint {
    Position position;
    Direction conormal; /**< smooth, towards the missing area */
    std::size_t island;
    double loop_length;
  };
  struct Node {
    Position center = Position::Zero();
    double radius = 0.0;
    double longest = 0.0;   /**< of the loops */
    std::size_t island = 0; /**< NONE: of several islands */
    std::size_t begin = 0;  /**< in points_ */
    std::size_t end = 0;
    std::size_t right = 0; /**< second child, the first one follows; 0: a leaf */
  };

  void
  addPoints(const BoundaryLoop& loop);
  std::size_t
  build(std::size_t begin, std::size_t end);
  void
  measure(Node& node) const;
  bool
  seesAnother(const BoundaryPoint& from) const;
  bool
  mayHold(const Node& node, const BoundaryPoint& from) const;

  std::vector<BoundaryPoint> by_loop_;
  std::vector<std::size_t> first_of_loop_; /**< in by_loop_; one more than loops */
  std::vector<BoundaryPoint> points_;      /**< in the order of the tree */
  std::vector<Node> nodes_;
};

} // namespace pcl::repair
