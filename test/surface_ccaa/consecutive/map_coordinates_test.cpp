// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: classes on clouds of floats take map coordinates by the
// global shift.
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/global_shift.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"

namespace pcl::ccaa::test {
namespace {

/** As the page of the global shift says. */
pcl::PolygonMesh
reconstructed(const pcl::PCLPointCloud2& cloud)
{
  const auto shift = GlobalShift::of(cloud);
  pcl::PCLPointCloud2 local;
  EXPECT_TRUE(shift.toLocal(cloud, local));
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::fromPCLPointCloud2(local, *points);
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(points);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct(mesh);
  EXPECT_TRUE(shift.restore(cloud, mesh));
  return mesh;
}

TEST(MapCoordinates, AreReconstructedByTheShiftToTheSameTriangles)
{
  const Positions points = onGrid(bumpySphere(3000));
  const pcl::PCLPointCloud2 cloud = toDoubleCloud(shifted(points, MAP_PLACE));
  const pcl::PolygonMesh near = reconstructed(toDoubleCloud(points));
  const pcl::PolygonMesh far = reconstructed(cloud);
  EXPECT_FALSE(near.polygons.empty());
  EXPECT_EQ(toTriangles(near.polygons), toTriangles(far.polygons));
  EXPECT_EQ(cloud.data, far.cloud.data);
}

} // namespace
} // namespace pcl::ccaa::test
