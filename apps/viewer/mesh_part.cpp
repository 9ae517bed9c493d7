// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a part of a model, cut out as a mesh of its own.
#include "viewer/mesh_part.h"

#include "io/cloud_assembler.h"
#include "mesh/corners.h"
#include "mesh/sort_unique.h"

#include <algorithm>

namespace app {
namespace {

using pcl::repair::IncompleteModel;
using pcl::repair::Triangle;

std::vector<const Triangle*>
trianglesIn(const IncompleteModel& model, const Eigen::AlignedBox3d& box)
{
  std::vector<char> is_inside;
  is_inside.reserve(model.positions.size());
  for (const Eigen::Vector3d& position : model.positions)
    is_inside.push_back(box.contains(position) ? 1 : 0);
  std::vector<const Triangle*> chosen;
  for (const Triangle& triangle : model.triangles)
    if (std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
          return is_inside[static_cast<std::size_t>(corner)] != 0;
        }))
      chosen.push_back(&triangle);
  return chosen;
}

void
append(std::vector<double>& numbers, const Eigen::Vector3d& vector)
{
  numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
}

pcl::PCLPointCloud2
freePointsIn(const IncompleteModel& model, const Eigen::AlignedBox3d& box)
{
  std::vector<double> positions;
  for (const Eigen::Vector3d& position : model.free_points)
    if (box.contains(position))
      append(positions, position);
  pcl::PCLPointCloud2 cloud;
  assembleCloud(positions, {}, cloud);
  return cloud;
}

} // namespace

pcl::index_t
MeshPart::pointFor(pcl::index_t point) const
{
  const auto at = std::lower_bound(point_of.begin(), point_of.end(), point);
  return static_cast<pcl::index_t>(at - point_of.begin());
}

MeshPart
cutPart(const IncompleteModel& model, const Eigen::AlignedBox3d& box)
{
  MeshPart part;
  const auto pointAt = [&](pcl::index_t vertex) {
    return model.point_of_vertex[static_cast<std::size_t>(vertex)];
  };
  const std::vector<const Triangle*> triangles = trianglesIn(model, box);
  for (const Triangle* triangle : triangles)
    for (const pcl::index_t corner : *triangle)
      part.point_of.push_back(pointAt(corner));
  pcl::ccaa::sortUnique(part.point_of);
  std::vector<Eigen::Vector3d> places(part.point_of.size());
  std::vector<Eigen::Vector3d> normals(places.size(), Eigen::Vector3d::Zero());
  for (const Triangle* triangle : triangles) {
    pcl::Vertices polygon;
    const pcl::ccaa::Corners corners = pcl::ccaa::cornersOf(*triangle, model.positions);
    for (std::size_t i = 0; i < 3; ++i) {
      const pcl::index_t corner = (*triangle)[i];
      polygon.vertices.push_back(part.pointFor(pointAt(corner)));
      places[static_cast<std::size_t>(polygon.vertices.back())] = corners[i];
    }
    for (const pcl::index_t point : polygon.vertices)
      normals[static_cast<std::size_t>(point)] += pcl::ccaa::areaNormal(corners);
    part.mesh.polygons.push_back(std::move(polygon));
  }
  std::vector<double> positions;
  std::vector<float> directions;
  for (std::size_t i = 0; i < places.size(); ++i) {
    append(positions, places[i]);
    for (const double part_of_normal : normals[i].stableNormalized())
      directions.push_back(static_cast<float>(part_of_normal));
  }
  assembleCloud(positions, {normalArray(directions)}, part.mesh.cloud);
  part.free_points = freePointsIn(model, box);
  return part;
}

} // namespace app
