// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what differs between versions of PCL, in one place.
#pragma once

#include <pcl/pcl_config.h>
#include <pcl/PCLPointField.h>

#include <cstdint>
#include <utility>

namespace pcl {

template <typename PointT>
class PointCloud;

namespace search {

template <typename PointT>
class Search;

} // namespace search

namespace ccaa {

/** \brief What Search::setInputCloud() returns: nothing before PCL 1.14, since then
 * whether it took the cloud. A function of this type ends with
 * \code return static_cast<SetInputResult<PointT>>(success); \endcode */
template <typename PointT>
using SetInputResult = decltype(std::declval<search::Search<PointT>&>().setInputCloud(
    std::declval<const typename PointCloud<PointT>::ConstPtr&>()));

#if PCL_VERSION_COMPARE(<, 1, 13, 0)
/** \brief Names of all types a point field can have. PCL 1.12 has none for the last
 * three; the numbers are those of PCL 1.13. */
struct PointFieldNames : PCLPointField {
  static constexpr std::uint8_t INT64 = 9;
  static constexpr std::uint8_t UINT64 = 10;
  static constexpr std::uint8_t BOOL = 11;
};
#else
/** \brief Names of all types a point field can have. */
using PointFieldNames = PCLPointField;
#endif

} // namespace ccaa
} // namespace pcl
