// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the nearest position of another kind.
#pragma once

#include <Eigen/Geometry>

#include "icadm/incomplete_model.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Positions with labels, to be asked for the nearest one whose label is another
 * than a given one. Parts of the tree with that label alone are passed over, so that
 * the own island costs nothing, however large and near it is.
 *
 * Cost: log-linear to build, logarithmic to ask. Const methods may be called from
 * several threads. */
class LabelledTree {
public:
  LabelledTree() = default;

  /** \param[in] labels one a position */
  LabelledTree(Positions positions, std::vector<std::size_t> labels);

  /** \brief Distance to the nearest position with another label than this, or with any
   * when it is NONE; infinite when there is none. */
  double
  distanceToOther(const Position& position, std::size_t label) const;

private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t label = NONE; /**< of all below; NONE: they differ */
    std::size_t begin = 0, end = 0;
    std::size_t children = 0; /**< index of the first of two; 0: a leaf */
  };

  void
  build(std::size_t node, std::vector<std::size_t>& order);
  void
  descend(const Node& node,
          const Position& position,
          std::size_t label,
          double& squared) const;

  Positions positions_;
  std::vector<std::size_t> labels_;
  std::vector<Node> nodes_;
};

} // namespace pcl::repair
