// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the libraries hold the templates for all types of points.
#include <pcl/common/io.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/projection_completion.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <boost/preprocessor/seq/enum.hpp>

#include "support/clouds.h"
#include "support/mesh_asserts.h"

#include <limits>

namespace pcl::ccaa::test {
namespace {

template <typename PointT>
void
forgetSensor(PointT&)
{}

void
forgetSensor(PointWithViewpoint& point)
{
  point.vp_x = point.vp_y = point.vp_z = std::numeric_limits<float>::quiet_NaN();
}

/** The sphere, its other fields 0: as normals they tell no side. A sensor there would
 * be one within the sphere. */
template <typename PointT>
typename PointCloud<PointT>::Ptr
sphereOf()
{
  auto cloud = pcl::make_shared<PointCloud<PointT>>();
  for (const Position& position : fibonacciSphere(200)) {
    PointT point;
    pcl::copyPoint(*toCloud({position})->begin(), point);
    forgetSensor(point);
    cloud->push_back(point);
  }
  return cloud;
}

template <typename Algorithm, typename PointT>
Triangles
triangulate()
{
  Algorithm algorithm;
  algorithm.setInputCloud(sphereOf<PointT>());
  algorithm.setSearchMethod(pcl::make_shared<search::BlockSearch<PointT>>());
  std::vector<Vertices> polygons;
  algorithm.reconstruct(polygons);
  return toTriangles(polygons);
}

template <typename PointT>
class PointTypes : public ::testing::Test {};

using AllTypes = ::testing::Types<BOOST_PP_SEQ_ENUM(PCL_XYZ_POINT_TYPES)>;
TYPED_TEST_SUITE(PointTypes, AllTypes, );

TYPED_TEST(PointTypes, AreAllReconstructedAlike)
{
  const auto triangles = triangulate<ConsecutiveReconstruction<TypeParam>, TypeParam>();
  EXPECT_EQ(triangles.size(), 396u);
  EXPECT_EQ(triangles, (triangulate<ConsecutiveReconstruction<PointXYZ>, PointXYZ>()));
}

TYPED_TEST(PointTypes, AreAllStartedFromAlike)
{
  EXPECT_EQ((triangulate<GreedyStart<TypeParam>, TypeParam>()),
            (triangulate<GreedyStart<PointXYZ>, PointXYZ>()));
}

TYPED_TEST(PointTypes, AreAllCompletedAlike)
{
  EXPECT_EQ((triangulate<ProjectionCompletion<TypeParam>, TypeParam>()),
            (triangulate<ProjectionCompletion<PointXYZ>, PointXYZ>()));
}

} // namespace
} // namespace pcl::ccaa::test
