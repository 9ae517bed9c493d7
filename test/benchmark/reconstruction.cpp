// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what every method that is compared gives back.
#include "reconstruction.h"

#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include "measuring.h"

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

pcl::ccaa::Triangles
toTriangles(const std::vector<pcl::Vertices>& polygons)
{
  pcl::ccaa::Triangles triangles;
  triangles.reserve(polygons.size());
  for (const pcl::Vertices& polygon : polygons)
    for (std::size_t i = 2; i < polygon.vertices.size(); ++i)
      triangles.push_back(
          {polygon.vertices[0], polygon.vertices[i - 1], polygon.vertices[i]});
  return triangles;
}

Reconstruction
reconstruct(const Cloud::Ptr& cloud, unsigned int threads)
{
  Reconstruction result;
  pcl::PolygonMesh::Ptr mesh;
  result.seconds = secondsOf([&] { mesh = makeMesh(cloud, threads); });
  result.triangles = toTriangles(mesh->polygons);
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
