// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: geometric predicates that never err.
#pragma once

#include "mesh/triangle.h"

namespace pcl::ccaa {

/** \brief The plane through three points, which tells on which side others lie. */
class ExactPlane {
public:
  ExactPlane(const Position& a, const Position& b, const Position& c);

  /** \brief 1 when the three points turn counter-clockwise seen from p, -1 when
   * clockwise, 0 when the four are coplanar.
   *
   * Exact for all finite doubles: a floating-point filter answers when rounding cannot
   * have changed the sign (some 10 ns with the plane), integers of sufficient length
   * otherwise: some 0.1 us for coordinates that are multiples of 2^n below 2^(n + 40),
   * as nearly all floats of a cloud are, 1 us for up to 80 bits. */
  int
  sideOf(const Position& p) const;

private:
  Position a_, b_, c_;
  Eigen::Vector3d normal_;
  Eigen::Vector3d magnitude_; /**< of the products that the normal is made of */
};

/** \brief The side of one point d, see ExactPlane. */
int
sideOfPlane(const Position& a, const Position& b, const Position& c, const Position& d);

/** \brief The same in the plane that is left when coordinate `dropped` (0 to 2) is left
 * out: 1 when a, b, c turn counter-clockwise, the other two axes taken in cyclic order.
 */
int
turnInPlane(const Position& a, const Position& b, const Position& c, int dropped);

/** \brief A coordinate that can be dropped without making the triangle collinear, or -1
 * when the three points are collinear. */
int
droppableAxis(const Position& a, const Position& b, const Position& c);

} // namespace pcl::ccaa
