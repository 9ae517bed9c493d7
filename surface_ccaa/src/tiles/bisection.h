// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: space cut so that each part holds as many points.
#pragma once

#include "mesh/box_tree.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief A box and about how many points lie in it, evenly. */
struct CountedBox {
  Box box;
  double count = 0.0;
};

/** \brief Cuts space into boxes of about as many points each by recursive coordinate
 * bisection (Berger and Bokhari 1987), as often as parts of so many points ask for:
 * across the axis with the fewest points near the plane. What lies in one place is not
 * cut.
 * \param[in] boxes the result depends on their order, by rounding only
 * \return half open, the outer ones unbounded; points at one of the lower faces belong
 * to it. Cost: O(n log parts). */
std::vector<Box>
bisect(const std::vector<CountedBox>& boxes, std::uint64_t points_each);

/** \brief Whether a position lies in one of them. */
inline bool
holds(const Box& half_open, const Eigen::Vector3d& position)
{
  return (position.array() >= half_open.min().array()).all() &&
         (position.array() < half_open.max().array()).all();
}

} // namespace pcl::ccaa
