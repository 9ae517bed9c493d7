// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points in the order of a space-filling curve.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::ccaa {

/** \brief Indices of the finite points, ordered along a Hilbert curve.
 *
 * Neighbors on the curve are neighbors in space, so whoever visits points in this order
 * finds their data in the cache, however the cloud was written. Points of equal
 * coordinates are adjacent and ascend by index (see removeDuplicates()). Points with a
 * NaN or infinite coordinate are left out.
 *
 * The curve adapts: where a far outlier makes many points share a cell, the cell gets a
 * curve of its own, as often as needed. Cost O(N) for ordinary clouds, O(N log N) at
 * worst; 32 bytes per point while it runs. The result does not depend on \a threads.
 * \param[in] points the coordinates
 * \param[in] threads number of threads, at least 1 */
std::vector<index_t>
curveOrder(const PointArray& points, int threads);

/** \brief The same for chosen points only.
 * \param[in] points the coordinates
 * \param[in] selection indices into \a points, each less than points.size
 * \param[in] threads number of threads, at least 1 */
std::vector<index_t>
curveOrder(const PointArray& points, const Indices& selection, int threads);

/** \brief The same for the places placeOf(0), ..., placeOf(count - 1) in double
 * precision: singles are enough for their shares of the box around them, wherever that
 * lies. */
template <typename PlaceOf>
std::vector<index_t>
curveOrder(std::size_t count, const PlaceOf& placeOf, int threads)
{
  constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < count; ++i)
    if (const Eigen::Vector3d place = placeOf(i); place.allFinite())
      box.extend(place);
  const double scale = 1.0 / std::max(box.sizes().maxCoeff(), 1e-300);
  std::vector<float> shares;
  shares.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d place = placeOf(i);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double share = (place[axis] - box.min()[axis]) * scale;
      const float overflown = std::isfinite(place[axis]) ? 0.0F : nowhere;
      shares.push_back(std::isfinite(share) ? static_cast<float>(share) : overflown);
    }
  }
  return curveOrder({shares.data(), 3, count}, threads);
}

/** \brief One index per distinct point, in curve order.
 *
 * Of several points with exactly equal coordinates the lowest index stays, because
 * curveOrder() puts it first. Cost O(N).
 * \param[in] points the coordinates
 * \param[in] order a result of curveOrder() for these points */
std::vector<index_t>
removeDuplicates(const PointArray& points, const std::vector<index_t>& order);

} // namespace pcl::ccaa
