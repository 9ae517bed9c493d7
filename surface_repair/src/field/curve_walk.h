// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: places and directions along a closed curve by arc length.
#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A closed curve parametrised by arc length: positions, and the integral of the
 * normals, so that means over any window cost two look-ups. The curve must outlive it.
 */
class CurveWalk {
public:
  explicit CurveWalk(const BoundaryCurve& curve);

  double
  length() const
  {
    return arcs_.back();
  }

  /** \brief The point at an arc length, of any sign and beyond any number of turns. */
  Position
  positionAt(double arc) const;

  /** \brief Integral of the normals from the first point to an arc length. */
  Eigen::Vector3d
  normalIntegral(double arc) const;

  /** \brief Index of the edge at an arc length. */
  std::size_t
  edgeAt(double arc) const;

private:
  /** \brief The arc length within the first turn. */
  double
  wrapped(double arc) const;

  /** \brief Share of edge k that lies before a wrapped arc length. */
  double
  shareOf(std::size_t k, double arc) const;

  Eigen::Vector3d
  normalOf(std::size_t k) const;

  const BoundaryCurve& curve_;
  std::vector<double> arcs_;   /**< at the points, and once more at the first */
  Positions normal_integrals_; /**< likewise */
};

} // namespace pcl::repair
