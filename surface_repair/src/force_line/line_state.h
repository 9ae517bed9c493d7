// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: direction and normal of a force line at a point (4.44).

#pragma once

#include "boundary/boundary_loop.h"
#include "force_line/normal_search.h"

#include <cstddef>

namespace pcl::repair {

/** \brief What the field says about a line at a point. */
struct LineState {
  Direction direction = Direction::Zero(); /**< f / |f|; zero where there is no force */
  Direction normal = Direction::Zero();    /**< across the direction */
  double tension = 0.0;                    /**< |f| */
  bool undetermined = false; /**< discontinuity point: the normal was carried along */
};

/** \brief Direction and normal at a point where the tension is known, continuing those
 * of \a before: the plane of 4.44-1b is across the direction, which is found by a few
 * rounds of n(p), p = unit(H n). */
LineState
stateAt(const Tension& tension, const LineState& before, double least_clearness);

/** \brief The part of a vector across a unit vector, brought to unit length; zero when
 * there is none. */
Direction
unitAcross(const Eigen::Vector3d& vector, const Direction& unit);

/** \brief Across the end of a line: the compatibility vector (EC4.421-2b) where it
 * agrees with the normal of the boundary, else that normal; zero when there is none.
 * \param[in] along direction of the line \param[in] edge of the curve, where it ends */
Direction
normalAtTarget(const Direction& along, const BoundaryCurve& curve, std::size_t edge);

} // namespace pcl::repair
