// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the nearest of many triangles.

#pragma once

#include "icadm/incomplete_model.h"
#include "mesh/box_tree.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::repair {

/** \brief A place on a triangle. */
struct TrianglePlace {
  std::size_t triangle = NONE;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  double distance = 0.0; /**< from what was asked for */

  bool
  found() const
  {
    return triangle != NONE;
  }
};

/** \brief The place on a triangle nearest to a point; one without area counts as its
 * edges. Its index is left open. */
TrianglePlace
nearestPlace(const Position& point, const ccaa::Corners& triangle);

/** \brief Finds the nearest of some triangles. Cost of a point close by: some us. */
class TriangleSearch {
public:
  /** \brief Whether a triangle counts; empty: each does. */
  using Filter = std::function<bool(const ccaa::Corners&)>;

  explicit TriangleSearch(std::vector<ccaa::Corners> triangles);

  /** \brief The nearest place within a reach, of the lowest triangle among equals. */
  TrianglePlace
  nearest(const Position& point, double reach, const Filter& counts = {}) const;

  /** \brief A triangle by its index. */
  const ccaa::Corners&
  operator[](std::size_t triangle) const
  {
    return triangles_[triangle];
  }

private:
  std::vector<ccaa::Corners> triangles_;
  ccaa::BoxTree tree_;
};

} // namespace pcl::repair
