// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far the field has to reach, from the data (4.45).

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/surface_repair/field/reach.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace repair {

double
meanPointSpacing(const Positions& points)
{
  if (points.size() < 2)
    return 0.0;
  // Floats of coordinates far from the origin would not tell neighbours apart.
  const Position origin = points.front();
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Position& point : points) {
    const Eigen::Vector3f local = (point - origin).cast<float>();
    cloud->emplace_back(local.x(), local.y(), local.z());
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  pcl::Indices nearest;
  std::vector<float> squared;
  double sum = 0.0;
  for (const pcl::PointXYZ& point : *cloud) {
    tree.nearestKSearch(point, 2, nearest, squared);
    sum += std::sqrt(static_cast<double>(squared.back()));
  }
  return sum / static_cast<double>(points.size());
}

double
GapFinder::gapAt(const Position& position, std::size_t silent_island) const
{
  double squared = std::numeric_limits<double>::infinity();
  for (const SourceCurve& curve : sources_.curves)
    if (curve.island != silent_island)
      for (const FieldSource& source : curve.sources)
        squared = std::min(squared, (source.position - position).squaredNorm());
  return std::sqrt(squared);
}

} // namespace repair
} // namespace pcl
