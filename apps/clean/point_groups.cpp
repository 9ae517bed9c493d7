// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points that become one.
#include "point_groups.h"

#include <pcl/common/point_tests.h>
#include <pcl/surface_ccaa/block_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace app {

void
PointGroups::close()
{
  std::sort(members.begin() + static_cast<std::ptrdiff_t>(begins.back()),
            members.end());
  begins.push_back(members.size());
}

PointGroups
PointGroups::unfolded(const PointGroups& items) const
{
  PointGroups result;
  for (std::size_t g = 0; g < size(); ++g) {
    for (std::size_t m = begins[g]; m < begins[g + 1]; ++m) {
      const auto item = static_cast<std::size_t>(members[m]);
      const auto first = items.members.begin();
      result.members.insert(result.members.end(),
                            first + static_cast<std::ptrdiff_t>(items.begins[item]),
                            first +
                                static_cast<std::ptrdiff_t>(items.begins[item + 1]));
    }
    result.close();
  }
  return result;
}

PointGroups
PointGroups::singles(const pcl::Indices& items)
{
  PointGroups result;
  for (const pcl::index_t item : items) {
    result.members.push_back(item);
    result.close();
  }
  return result;
}

PointGroups
groupByCell(const pcl::PointCloud<pcl::PointXYZ>& points, double cell)
{
  using Cell = std::array<double, 3>; // whole numbers, however far out
  const auto place = [cell](double x) { return cell > 0 ? std::floor(x / cell) : x; };
  std::vector<std::pair<Cell, pcl::index_t>> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const pcl::PointXYZ& point = points[i]; pcl::isFinite(point))
      cells.emplace_back(Cell{place(point.x), place(point.y), place(point.z)},
                         static_cast<pcl::index_t>(i));
  std::sort(cells.begin(), cells.end());
  PointGroups groups;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    groups.members.push_back(cells[i].second);
    if (i + 1 == cells.size() || cells[i + 1].first != cells[i].first)
      groups.close();
  }
  return groups;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
meansOf(const PointGroups& groups, const pcl::PointCloud<pcl::PointXYZ>& points)
{
  auto means = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  means->reserve(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t m = groups.begins[g]; m < groups.begins[g + 1]; ++m)
      sum += points[static_cast<std::size_t>(groups.members[m])]
                 .getVector3fMap()
                 .cast<double>();
    const Eigen::Vector3f mean =
        (sum / static_cast<double>(groups.sizeOf(g))).cast<float>();
    means->emplace_back(mean.x(), mean.y(), mean.z());
  }
  return means;
}

Thinning
thin(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
     const std::vector<std::size_t>& weights,
     double distance)
{
  pcl::search::BlockSearch<pcl::PointXYZ> search;
  search.setInputCloud(points);
  pcl::Indices order(points->size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](pcl::index_t a, pcl::index_t b) {
    return weights[static_cast<std::size_t>(a)] > weights[static_cast<std::size_t>(b)];
  });
  std::vector<bool> taken(points->size(), false);
  Thinning result;
  pcl::Indices near;
  std::vector<float> sqr_distances;
  for (const pcl::index_t i : order) {
    if (taken[static_cast<std::size_t>(i)])
      continue;
    const pcl::PointXYZ& point = (*points)[static_cast<std::size_t>(i)];
    search.radiusSearch(point, distance, near, sqr_distances);
    result.kept.push_back(i);
    for (const pcl::index_t other : near) {
      if (taken[static_cast<std::size_t>(other)])
        continue;
      taken[static_cast<std::size_t>(other)] = true;
      result.groups.members.push_back(other);
    }
    result.groups.close();
  }
  return result;
}

} // namespace app
