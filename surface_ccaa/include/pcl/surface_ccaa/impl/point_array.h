// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: coordinates that lie anywhere, and indices that are none of
// theirs.
#pragma once

#include <pcl/types.h>

#include <cstddef>
#include <string>

namespace pcl {

template <typename PointT>
class PointCloud;

namespace ccaa {

/** \brief A view of coordinates that lie anywhere: point i starts at xyz + i * stride.
 * Three floats in a row, then whatever the owner keeps there. */
struct PointArray {
  /** \brief First coordinate of the first point; may be null when size is 0. */
  const float* xyz = nullptr;
  /** \brief Floats from one point to the next, at least 3. */
  std::size_t stride = 3;
  /** \brief Number of points. */
  std::size_t size = 0;

  const float*
  operator[](index_t point_index) const
  {
    return xyz + static_cast<std::size_t>(point_index) * stride;
  }
};

/** \brief The coordinates of a cloud, which must outlive the view. */
template <typename PointT>
PointArray
pointArrayOf(const PointCloud<PointT>& cloud)
{
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points are rows of floats");
  if (cloud.empty())
    return {};
  return {&cloud.front().x, sizeof(PointT) / sizeof(float), cloud.size()};
}

/** \brief The first index that is none of a cloud with so many points; the end when all
 * are. */
Indices::const_iterator
findIndexOutside(const Indices& indices, std::size_t point_count);

/** \brief What is wrong with indices of a cloud, for messages; empty: nothing is. */
std::string
indexFault(const Indices& indices, std::size_t point_count);

} // namespace ccaa
} // namespace pcl
