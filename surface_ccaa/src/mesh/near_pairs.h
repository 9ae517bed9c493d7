// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points near each other.
#pragma once

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include "mesh/point_view.h"

#include <memory>
#include <vector>

namespace pcl::ccaa {

/** \brief Call visit(one, other) for all pairs of some points of which the second is
 * within reachOf(one) of the first, in the order of the first.
 * \param[in] reachOf may be 0, for points that are no first one */
template <typename ReachOf, typename Visit>
void
forNearPairs(const std::vector<pcl::index_t>& among,
             const PointView& points,
             const ReachOf& reachOf,
             const Visit& visit)
{
  if (among.size() < 2)
    return;
  const Position origin = points[among.front()];
  auto cloud = std::make_shared<PointCloud<PointXYZ>>();
  for (const pcl::index_t v : among) {
    const Eigen::Vector3f place = (points[v] - origin).template cast<float>();
    cloud->push_back(PointXYZ(place.x(), place.y(), place.z()));
  }
  KdTreeFLANN<PointXYZ> tree;
  tree.setInputCloud(cloud);
  Indices near;
  std::vector<float> squared;
  for (std::size_t i = 0; i < among.size(); ++i) {
    const double reach = reachOf(among[i]);
    if (reach <= 0.0)
      continue;
    tree.radiusSearch((*cloud)[i], reach, near, squared);
    for (const pcl::index_t place : near)
      if (static_cast<std::size_t>(place) != i)
        visit(among[i], among[static_cast<std::size_t>(place)]);
  }
}

} // namespace pcl::ccaa
