// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points that become one.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace app {

/** \brief Disjoint groups of items; each has members in ascending order. */
struct PointGroups {
  std::vector<std::size_t> begins = {0}; /**< one more than there are groups */
  pcl::Indices members;

  std::size_t
  size() const
  {
    return begins.size() - 1;
  }

  std::size_t
  sizeOf(std::size_t group) const
  {
    return begins[group + 1] - begins[group];
  }

  /** \brief End the group that was filled last. */
  void
  close();

  /** \brief Groups of groups of \a items, as groups of what these have. */
  PointGroups
  unfolded(const PointGroups& items) const;

  /** \brief Groups of one item each. */
  static PointGroups
  singles(const pcl::Indices& items);
};

/** \brief The finite points by cells of a cubic grid, cells in the order of their
 * coordinates; O(N log N).
 * \param[in] cell edge in units of the points, 0: only equal points share one */
PointGroups
groupByCell(const pcl::PointCloud<pcl::PointXYZ>& points, double cell);

/** \brief The mean of each group. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
meansOf(const PointGroups& groups, const pcl::PointCloud<pcl::PointXYZ>& points);

/** \brief Points that stay, and for each the group of those it stands for. */
struct Thinning {
  pcl::Indices kept;
  PointGroups groups;
};

/** \brief Leave points that are farther apart than \a distance: those with more weight
 * first, of equals the lower index, and each takes up all others so near to it. All
 * points are finite. */
Thinning
thin(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
     const std::vector<std::size_t>& weights,
     double distance);

} // namespace app
