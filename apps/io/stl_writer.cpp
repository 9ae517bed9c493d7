// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes binary STL.
#include <Eigen/Geometry>

#include "mesh_writers.h"
#include "point_columns.h"

#include <array>

namespace app {
namespace {

void
writeTriangle(const std::array<Eigen::Vector3f, 3>& corners, OutputFile& file)
{
  const Eigen::Vector3d a = corners[0].cast<double>();
  const Eigen::Vector3d normal =
      (corners[1].cast<double>() - a).cross(corners[2].cast<double>() - a);
  const double length = normal.norm();
  const Eigen::Vector3f unit = length > 0
                                   ? Eigen::Vector3f((normal / length).cast<float>())
                                   : Eigen::Vector3f(0, 0, 0);
  file.write(unit.data(), 3 * sizeof(float));
  for (const Eigen::Vector3f& corner : corners)
    file.write(corner.data(), 3 * sizeof(float));
  file.write("\0\0", 2);
}

} // namespace

void
writeStl(const pcl::PolygonMesh& mesh, OutputFile& file)
{
  std::size_t triangles = 0;
  for (const pcl::Vertices& polygon : mesh.polygons)
    triangles += polygon.vertices.size() < 3 ? 0 : polygon.vertices.size() - 2;
  std::string header = "binary STL by PclSurfaceRepair";
  header.resize(80, ' ');
  file.text(header);
  const auto count = static_cast<std::uint32_t>(triangles);
  file.write(&count, sizeof(count));
  const std::vector<Eigen::Vector3f> positions = readPositions(mesh.cloud);
  const auto at = [&](pcl::index_t i) {
    return positions[static_cast<std::size_t>(i)];
  };
  for (const pcl::Vertices& polygon : mesh.polygons) {
    const auto& corners = polygon.vertices;
    for (std::size_t i = 2; i < corners.size(); ++i)
      writeTriangle({at(corners[0]), at(corners[i - 1]), at(corners[i])}, file);
  }
}

} // namespace app
