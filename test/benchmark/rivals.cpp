// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the field offers, for comparison in the same run.
#include "rivals.h"

#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

#ifdef PSR_HAVE_CGAL
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace bench {

pcl::PolygonMesh
greedyProjection(const Cloud::Ptr& cloud, double spacing, double radius)
{
  const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  pcl::PointCloud<pcl::PointNormal>::Ptr oriented(
      new pcl::PointCloud<pcl::PointNormal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(12);
  estimation.compute(*oriented);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*oriented)[i].getVector3fMap() = (*cloud)[i].getVector3fMap();
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  triangulation.setInputCloud(oriented);
  triangulation.setSearchMethod(
      std::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  triangulation.setSearchRadius(radius * spacing);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(30);
  triangulation.setMaximumSurfaceAngle(M_PI / 4);
  triangulation.setMinimumAngle(M_PI / 18);
  triangulation.setMaximumAngle(2 * M_PI / 3);
  triangulation.setNormalConsistency(false);
  pcl::PolygonMesh mesh;
  triangulation.reconstruct(mesh);
  return mesh;
}

double
spacingOf(const Cloud::Ptr& cloud)
{
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  pcl::Indices near;
  std::vector<float> sqr_distances;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud->size(); i += cloud->size() / 1000 + 1, ++count) {
    tree.nearestKSearch((*cloud)[i], 7, near, sqr_distances);
    sum += std::sqrt(sqr_distances.back());
  }
  return count > 0 ? sum / double(count) : 0;
}

#ifdef PSR_HAVE_CGAL

bool
hasAdvancingFront()
{
  return true;
}

std::size_t
advancingFront(const Cloud& cloud)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& p : cloud)
    points.emplace_back(p.x, p.y, p.z);
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(
      points.begin(), points.end(), std::back_inserter(triangles));
  return triangles.size();
}

#else

bool
hasAdvancingFront()
{
  return false;
}

std::size_t
advancingFront(const Cloud&)
{
  return 0;
}

#endif

} // namespace bench
