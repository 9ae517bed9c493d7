// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a user's program with a point type of its own.

// PCL's way to use its templates with a type no library was compiled for.
#define PCL_NO_PRECOMPILE

#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cmath>
#include <cstdio>

struct ScanPoint {
  PCL_ADD_POINT4D;
  float range;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT(
    ScanPoint, (float, x, x)(float, y, y)(float, z, z)(float, range, range))

namespace {

/** \brief A sphere of radius 1, its points spread evenly on a golden spiral. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
makeSphere(int points)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < points; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / points;
    const double radius = std::sqrt(1.0 - z * z);
    PointT point{};
    point.x = static_cast<float>(radius * std::cos(golden_angle * i));
    point.y = static_cast<float>(radius * std::sin(golden_angle * i));
    point.z = static_cast<float>(z);
    cloud->push_back(point);
  }
  return cloud;
}

/** \brief Number of triangles the start algorithm and the filter leave on a sphere. */
template <typename PointT>
std::size_t
countTriangles()
{
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::GreedyStart<PointT> start;
  start.setInputCloud(makeSphere<PointT>(2000));
  start.reconstruct(*mesh);

  pcl::PolygonMesh correct;
  pcl::UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  filter.process(correct);
  return correct.polygons.size();
}

} // namespace

int
main()
{
  const std::size_t standard = countTriangles<pcl::PointXYZ>();
  const std::size_t custom = countTriangles<ScanPoint>();
  std::printf("triangles: %zu, with the custom point type %zu\n", standard, custom);
  return standard > 3000 && custom == standard ? 0 : 1;
}
