// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what every method that is compared gives back.
#include "reconstruction.h"

#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include "measuring.h"
#include "mesh/polygon_access.h"

namespace bench {
namespace {

pcl::PolygonMesh::Ptr
makeMesh(const Cloud::Ptr& cloud, unsigned int threads)
{
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  chain.setNumberOfThreads(threads);
  pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
  chain.reconstruct(*mesh);
  return mesh;
}

} // namespace

Reconstruction
reconstruct(const Cloud::Ptr& cloud, unsigned int threads)
{
  Reconstruction result;
  pcl::PolygonMesh::Ptr mesh;
  result.seconds = secondsOf([&] { mesh = makeMesh(cloud, threads); });
  result.triangles = pcl::ccaa::fanTriangles(mesh->polygons);
  return result;
}

double
peakBytesPerPoint(const Cloud::Ptr& cloud)
{
  pcl::PolygonMesh::Ptr mesh;
  const double bytes = peakBytesOf([&] { mesh = makeMesh(cloud, 0); });
  return (bytes - double(bytesOf(*mesh))) / double(cloud->size());
}

} // namespace bench
