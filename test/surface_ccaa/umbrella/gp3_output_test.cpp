// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the umbrella filter behind PCL's greedy projection.

#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include "filter_helpers.h"
#include "support/clouds.h"
#include "support/shared_data.h"

namespace pcl::ccaa::test {
namespace {

/** \brief GP3 on points without normals, with PCL's usual settings. */
pcl::PolygonMesh::Ptr
greedyProjection(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, double radius)
{
  auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(points);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(20);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  pcl::concatenateFields(*points, normals, *cloud);
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> gp3;
  gp3.setSearchRadius(radius);
  gp3.setMu(2.5);
  gp3.setMaximumNearestNeighbors(100);
  gp3.setMaximumSurfaceAngle(M_PI / 4);
  gp3.setMinimumAngle(M_PI / 18);
  gp3.setMaximumAngle(2 * M_PI / 3);
  gp3.setInputCloud(cloud);
  gp3.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  gp3.reconstruct(*mesh);
  return mesh;
}

void
expectGp3Certified(const pcl::PolygonMesh::Ptr& mesh)
{
  ASSERT_FALSE(mesh->polygons.empty());
  UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  pcl::PolygonMesh output;
  filter.process(output);
  const std::size_t count = mesh->cloud.width * mesh->cloud.height;
  const auto triangles = toTriangles(output.polygons);
  EXPECT_TRUE(isIcadm(triangles, count));
  EXPECT_TRUE(isSubsetOf(triangles, toTriangles(mesh->polygons)));
  EXPECT_GT(output.polygons.size(), mesh->polygons.size() * 7 / 10);
  const auto& report = filter.getReport();
  EXPECT_EQ(report.internal_points + report.boundary_points + report.free_points,
            count);
}

TEST(UmbrellaFilter, CertifiesGp3Output)
{
  expectGp3Certified(greedyProjection(toCloud(noisySphere(3000, 0.005)), 0.25));
}

TEST(UmbrellaFilter, CertifiesGp3OutputOfARealScan)
{
  const auto path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  Shape bunny;
  ASSERT_TRUE(readShape(path, bunny));
  expectGp3Certified(greedyProjection(toCloud(bunny.vertices), 0.01));
}

} // namespace
} // namespace pcl::ccaa::test
