// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a user's program with a point type of its own.

// PCL's way to use its templates with a type no library was compiled for.
#define PCL_NO_PRECOMPILE

#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/conversions.h>
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

/** \brief Whether the one boundary of a lone triangle is taken for a border. */
bool
knowsBorder()
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::PointCloud<pcl::PointXYZ> corners;
  corners.emplace_back(0.0F, 0.0F, 0.0F);
  corners.emplace_back(1.0F, 0.0F, 0.0F);
  corners.emplace_back(0.0F, 1.0F, 0.0F);
  pcl::toPCLPointCloud2(corners, mesh->cloud);
  mesh->polygons.resize(1);
  mesh->polygons[0].vertices = {0, 1, 2};
  pcl::BoundaryClassifier classifier;
  classifier.setInputMesh(mesh);
  std::vector<pcl::ClassifiedBoundary> boundaries;
  return classifier.classify(boundaries) && boundaries.size() == 1 &&
         boundaries[0].boundary_class == pcl::repair::BoundaryClass::OUTER_BORDER;
}

} // namespace

int
main()
{
  const std::size_t standard = countTriangles<pcl::PointXYZ>();
  const std::size_t custom = countTriangles<ScanPoint>();
  std::printf("triangles: %zu, with the custom point type %zu\n", standard, custom);
  return standard > 3000 && custom == standard && knowsBorder() ? 0 : 1;
}
