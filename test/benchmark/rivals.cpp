// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the field offers, for comparison in the same run.
#include "rivals.h"

#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

#include "measuring.h"
#include "mesh/polygon_access.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bench {
namespace {

using OrientedCloud = pcl::PointCloud<pcl::PointNormal>;

OrientedCloud::Ptr
withNormals(const Cloud::Ptr& cloud)
{
  OrientedCloud::Ptr oriented(new OrientedCloud);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(12);
  estimation.compute(*oriented);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*oriented)[i].getVector3fMap() = (*cloud)[i].getVector3fMap();
  return oriented;
}

void
project(const OrientedCloud::Ptr& oriented, double radius, pcl::PolygonMesh& mesh)
{
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  triangulation.setInputCloud(oriented);
  triangulation.setSearchMethod(
      std::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  triangulation.setSearchRadius(radius);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(30);
  triangulation.setMaximumSurfaceAngle(M_PI / 4);
  triangulation.setMinimumAngle(M_PI / 18);
  triangulation.setMaximumAngle(2 * M_PI / 3);
  triangulation.setNormalConsistency(false);
  triangulation.setConsistentVertexOrdering(true);
  triangulation.reconstruct(mesh);
}

/** GP3's radius is a trade of speed for coverage. */
double
fastestSensibleRadius(const Cloud::Ptr& cloud, double spacing)
{
  struct Try {
    double radius;
    double seconds;
    std::size_t triangles;
  };
  std::vector<Try> tries;
  std::size_t most = 0;
  for (const double radius : {1.25, 1.75, 2.5, 4.0}) {
    const Reconstruction result = greedyProjection(cloud, spacing, radius);
    tries.push_back({radius, result.seconds, result.triangles.size()});
    most = std::max(most, result.triangles.size());
  }
  const Try* best = nullptr;
  for (const Try& t : tries)
    if (t.triangles * 10 >= most * 9 && (best == nullptr || t.seconds < best->seconds))
      best = &t;
  return best->radius;
}

} // namespace

Reconstruction
greedyProjection(const Cloud::Ptr& cloud, double spacing, double radius)
{
  Reconstruction result;
  pcl::PolygonMesh mesh;
  result.seconds =
      secondsOf([&] { project(withNormals(cloud), radius * spacing, mesh); });
  result.triangles = pcl::ccaa::fanTriangles(mesh.polygons);
  return result;
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

std::vector<Method>
rivalsFor(const Cloud::Ptr& cloud)
{
  const double spacing = spacingOf(cloud);
  const double radius = fastestSensibleRadius(cloud, spacing);
  std::vector<Method> rivals;
  rivals.push_back(
      {"PCL GP3 + normals", [=] { return greedyProjection(cloud, spacing, radius); }});
  if (hasAdvancingFront())
    rivals.push_back({"CGAL advancing front", [=] { return advancingFront(*cloud); }});
  if (hasBallPivoting())
    rivals.push_back(
        {"Open3D ball pivoting", [=] { return ballPivoting(*cloud, spacing); }});
  return rivals;
}

} // namespace bench
