// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points in the order of a space-filling curve.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/types.h>

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

/** \brief One index per distinct point, in curve order.
 *
 * Of several points with exactly equal coordinates the lowest index stays, because
 * curveOrder() puts it first. Cost O(N).
 * \param[in] points the coordinates
 * \param[in] order a result of curveOrder() for these points */
std::vector<index_t>
removeDuplicates(const PointArray& points, const std::vector<index_t>& order);

} // namespace pcl::ccaa
