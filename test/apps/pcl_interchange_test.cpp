// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files go both ways between PCL's own input/output and ours.
#include <pcl/console/print.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/vtk_io.h>
#include <pcl/io/vtk_lib_io.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/point_columns.h"
#include "model_samples.h"

namespace app_test {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGBNormal>;

Cloud
pclCloud()
{
  Cloud cloud;
  pcl::fromPCLPointCloud2(colouredCloud(200), cloud);
  return cloud;
}

/** All that PCL's point type holds; the unused top byte of the colour does not count.
 */
void
expectSamePoints(const Cloud& expected, const Cloud& actual)
{
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i].getVector3fMap(), actual[i].getVector3fMap());
    EXPECT_EQ(expected[i].getNormalVector3fMap(), actual[i].getNormalVector3fMap());
    EXPECT_EQ(expected[i].r, actual[i].r);
    EXPECT_EQ(expected[i].g, actual[i].g);
    EXPECT_EQ(expected[i].b, actual[i].b);
  }
}

Cloud
loadAsPclCloud(const std::string& path)
{
  Cloud cloud;
  pcl::fromPCLPointCloud2(loadCloud(path).mesh.cloud, cloud);
  return cloud;
}

TEST(PclInterchange, ReadsEveryKindOfPcdThatPclWrites)
{
  const TemporaryFolder folder;
  const Cloud cloud = pclCloud();
  ASSERT_EQ(0, pcl::io::savePCDFileBinary(folder.path("b.pcd"), cloud));
  ASSERT_EQ(0, pcl::io::savePCDFileBinaryCompressed(folder.path("c.pcd"), cloud));
  pcl::PCDWriter().writeASCII(folder.path("a.pcd"), cloud, 9);
  for (const char* name : {"a.pcd", "b.pcd", "c.pcd"}) {
    SCOPED_TRACE(name);
    expectSamePoints(cloud, loadAsPclCloud(folder.path(name)));
  }
}

TEST(PclInterchange, ReadsPlyThatPclWrites)
{
  const TemporaryFolder folder;
  const Cloud cloud = pclCloud();
  ASSERT_EQ(0, pcl::io::savePLYFileBinary(folder.path("b.ply"), cloud));
  expectSamePoints(cloud, loadAsPclCloud(folder.path("b.ply")));
}

TEST(PclInterchange, ReadsMeshesThatPclWrites)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  pcl::io::savePLYFileBinary(folder.path("a.ply"), mesh);
  pcl::io::saveVTKFile(folder.path("a.vtk"), mesh, 9);
  pcl::io::saveOBJFile(folder.path("a.obj"), mesh, 9);
  pcl::io::savePolygonFileSTL(folder.path("a.stl"), mesh);
  pcl::io::savePolygonFileVTK(folder.path("b.vtk"), mesh);
  for (const char* name : {"a.ply", "a.vtk", "a.obj", "b.vtk"}) {
    SCOPED_TRACE(name);
    const app::Model model = loadMesh(folder.path(name));
    expectSamePolygons(mesh, model.mesh);
    EXPECT_EQ(app::pointCount(mesh.cloud), app::pointCount(model.mesh.cloud));
  }
  EXPECT_EQ(mesh.polygons.size(), loadMesh(folder.path("a.stl")).mesh.polygons.size());
}

TEST(PclInterchange, PclReadsOurClouds)
{
  const TemporaryFolder folder;
  const Cloud cloud = pclCloud();
  pcl::PCLPointCloud2 raw;
  pcl::toPCLPointCloud2(cloud, raw);
  for (const char* name : {"a.pcd", "a.ply"}) {
    SCOPED_TRACE(name);
    save(folder.path(name), raw);
    Cloud read;
    const bool is_pcd = std::string(name) == "a.pcd";
    ASSERT_EQ(0,
              is_pcd ? pcl::io::loadPCDFile(folder.path(name), read)
                     : pcl::io::loadPLYFile(folder.path(name), read));
    expectSamePoints(cloud, read);
  }
}

TEST(PclInterchange, PclReadsOurMeshes)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  for (const char* name : {"a.ply", "a.vtk", "a.obj", "a.stl"}) {
    SCOPED_TRACE(name);
    save(folder.path(name), mesh);
    pcl::PolygonMesh read;
    EXPECT_GT(pcl::io::loadPolygonFile(folder.path(name), read), 0);
    EXPECT_EQ(mesh.polygons.size(), read.polygons.size());
    EXPECT_EQ(app::pointCount(mesh.cloud), app::pointCount(read.cloud));
  }
}

TEST(PclInterchange, VtkLibraryReadsColoursOfOurVtk)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  save(folder.path("a.vtk"), mesh);
  pcl::PolygonMesh read;
  ASSERT_GT(pcl::io::loadPolygonFileVTK(folder.path("a.vtk"), read), 0);
  Cloud expected;
  Cloud actual;
  pcl::fromPCLPointCloud2(mesh.cloud, expected);
  pcl::fromPCLPointCloud2(read.cloud, actual);
  expectSamePoints(expected, actual);
}

} // namespace
} // namespace app_test
