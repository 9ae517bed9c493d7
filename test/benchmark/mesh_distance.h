// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far a mesh is from another one.
#pragma once

#include "mesh/box_tree.h"
#include "mesh/intersection.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace bench {

/** \brief Exact distance of a point from a closed triangle, in units of the cloud; a
 * triangle without area counts as its edges. */
double
distanceToTriangle(const pcl::ccaa::Position& point,
                   const pcl::ccaa::Corners& triangle);

/** \brief Answers how far points are from a mesh. Const calls may run in parallel. Cost
 * of a point close to the surface: a few us. */
class MeshDistance {
public:
  /** \brief Take in a mesh; its indices must be valid and its corners finite. */
  MeshDistance(const pcl::ccaa::Triangles& triangles,
               const pcl::ccaa::PointView& positions);

  /** \brief Exact distance from the nearest triangle; infinite for an empty mesh. */
  double
  operator()(const pcl::ccaa::Position& point) const;

private:
  double
  nearestWithin(const pcl::ccaa::Position& point, double reach) const;

  std::vector<pcl::ccaa::Corners> corners_;
  pcl::ccaa::BoxTree tree_;
  double first_reach_ = 0;
};

/** \brief Distances of a mesh from another, measured at the corners and centroids of
 * its triangles. Lengths in units of the cloud. */
struct Deviation {
  double mean = 0;    /**< of the triangles' four distances, weighted by area */
  double largest = 0; /**< at any of these places */
  std::size_t far_triangles = 0; /**< with one of them beyond the limit */
};

/** \brief How far triangles are from a mesh.
 * \param[in] limit distance from which a triangle counts as far */
Deviation
measureDeviation(const pcl::ccaa::Triangles& triangles,
                 const pcl::ccaa::PointView& positions,
                 const MeshDistance& distance,
                 double limit);

} // namespace bench
