// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where tests find their input files.
#include "shared_data.h"

#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include "mesh_asserts.h"

#include <cstdlib>
#include <fstream>

namespace pcl::ccaa::test {

std::string
sharedData(const std::string& name)
{
  const char* folder = std::getenv("PSR_SHARED_DATA");
  const std::string base = folder ? folder : PSR_SHARED_DATA_DIR;
  const std::string path = base + "/" + name;
  return std::ifstream(path) ? path : std::string();
}

std::string
testData(const std::string& name)
{
  return std::string(PSR_TEST_DATA_DIR "/") + name;
}

bool
readShape(const std::string& path, Shape& shape)
{
  pcl::PolygonMesh mesh;
  if (pcl::io::loadPLYFile(path, mesh) < 0)
    return false;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  shape = Shape();
  for (const pcl::PointXYZ& point : cloud)
    shape.vertices.push_back(point.getVector3fMap().cast<double>());
  shape.triangles = toTriangles(mesh.polygons);
  return true;
}

} // namespace pcl::ccaa::test
