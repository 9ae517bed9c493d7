// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what there is to say about a result, whoever made it.
#include "judgement.h"

#include <pcl/io/ply_io.h>

#include "mesh/cloud_access.h"
#include "mesh/polygon_access.h"
#include "run/threads.h"

#include <cstddef>
#include <stdexcept>

namespace bench {
namespace {

using pcl::ccaa::PointView;

PointView
viewOf(const Cloud& cloud)
{
  return {cloud.points.data(),
          cloud.size(),
          {sizeof(pcl::PointXYZ),
           {offsetof(pcl::PointXYZ, x),
            offsetof(pcl::PointXYZ, y),
            offsetof(pcl::PointXYZ, z)},
           false,
           0,
           0}};
}

double
diagonalOf(const pcl::ccaa::Triangles& triangles, const pcl::ccaa::Positions& positions)
{
  pcl::ccaa::Box box;
  for (const pcl::ccaa::Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      box.extend(positions[static_cast<std::size_t>(corner)]);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace

std::shared_ptr<const ReferenceMesh>
readReference(const std::string& file)
{
  pcl::PolygonMesh mesh;
  if (file.empty())
    return nullptr;
  if (pcl::io::loadPLYFile(file, mesh) < 0)
    throw std::runtime_error("cannot read " + file);
  if (mesh.polygons.empty())
    return nullptr;
  auto reference = std::make_shared<ReferenceMesh>();
  reference->triangles = pcl::ccaa::fanTriangles(mesh.polygons);
  reference->positions =
      pcl::ccaa::copyPositions(pcl::ccaa::positionView(mesh.cloud)).positions;
  reference->diagonal = diagonalOf(reference->triangles, reference->positions);
  pcl::ccaa::RunControl control;
  reference->facts = pcl::ccaa::measureMesh(
      reference->triangles, reference->positions, {false, 1}, control);
  return reference;
}

Judgement
judge(const Cloud& cloud,
      const pcl::ccaa::Triangles& triangles,
      const ReferenceMesh* reference)
{
  Judgement judgement;
  pcl::ccaa::RunControl control;
  const PointView points = viewOf(cloud);
  judgement.facts = pcl::ccaa::measureMesh(
      triangles, points, {true, pcl::ccaa::resolveThreads(0)}, control);
  if (reference == nullptr || triangles.empty())
    return judgement;
  const double limit = Judgement::FAR_SHARE * reference->diagonal;
  judgement.deviation =
      measureDeviation(triangles,
                       points,
                       MeshDistance(reference->triangles, reference->positions),
                       limit);
  judgement.missing = measureDeviation(reference->triangles,
                                       reference->positions,
                                       MeshDistance(triangles, points),
                                       limit);
  return judgement;
}

} // namespace bench
