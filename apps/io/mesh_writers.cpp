// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes meshes as OBJ, OFF and STL.
#include <Eigen/Geometry>

#include "point_columns.h"
#include "remarks.h"
#include "writers.h"

#include <array>

namespace app {
namespace {

/** x, y and z, with a space between them. */
void
writePosition(const std::uint8_t* point,
              const std::vector<PointColumn>& columns,
              OutputFile& file)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    file.text(axis == 0 ? "" : " ");
    writeAsText(point, columns.at(axis), file);
  }
}

/** Shares of one, which six digits bring back to the same byte. */
void
writeColourShares(const std::uint8_t* colour, OutputFile& file)
{
  for (std::size_t byte = 3; byte-- > 0;) {
    char digits[32];
    const auto end = std::to_chars(digits,
                                   digits + sizeof(digits),
                                   colour[byte] / 255.0,
                                   std::chars_format::general,
                                   6);
    file.text(" ");
    file.write(digits, static_cast<std::size_t>(end.ptr - digits));
  }
}

void
writeObjFace(const pcl::Vertices& polygon, bool has_normal, OutputFile& file)
{
  file.text("f");
  for (const pcl::index_t corner : polygon.vertices) {
    const std::int64_t number = std::int64_t{corner} + 1;
    file.text(" ");
    file.number(number);
    if (has_normal) {
      file.text("//");
      file.number(number);
    }
  }
  file.text("\n");
}

void
writeColourBytes(const std::uint8_t* colour, OutputFile& file)
{
  for (std::size_t byte = 3; byte-- > 0;) {
    file.text(" ");
    file.number(colour[byte]);
  }
  file.text(" 255");
}

void
writeOffFace(const pcl::Vertices& polygon, OutputFile& file)
{
  file.number(polygon.vertices.size());
  for (const pcl::index_t corner : polygon.vertices) {
    file.text(" ");
    file.number(corner);
  }
  file.text("\n");
}

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
writeObj(const pcl::PolygonMesh& mesh, const Remarks& remarks, OutputFile& file)
{
  const pcl::PCLPointCloud2& cloud = mesh.cloud;
  const std::vector<PointColumn> columns = listColumns(cloud);
  std::size_t colour = 0;
  std::size_t normal = 0;
  const bool has_colour = findColour(cloud, colour);
  const bool has_normal = findNormal(cloud, normal);
  const std::size_t points = pointCount(cloud);
  writeComments(remarks, file);
  for (std::size_t i = 0; i < points; ++i) {
    file.text("v ");
    writePosition(pointAt(cloud, i), columns, file);
    if (has_colour)
      writeColourShares(pointAt(cloud, i) + colour, file);
    file.text("\n");
  }
  for (std::size_t i = 0; has_normal && i < points; ++i) {
    file.text("vn");
    writeFloats(pointAt(cloud, i) + normal, file);
    file.text("\n");
  }
  for (const pcl::Vertices& polygon : mesh.polygons)
    writeObjFace(polygon, has_normal, file);
}

void
writeOff(const pcl::PolygonMesh& mesh, const Remarks& remarks, OutputFile& file)
{
  const pcl::PCLPointCloud2& cloud = mesh.cloud;
  std::size_t colour = 0;
  std::size_t normal = 0;
  const bool has_colour = findColour(cloud, colour);
  const bool has_normal = findNormal(cloud, normal);
  const std::vector<PointColumn> columns = listColumns(cloud);
  const std::size_t points = pointCount(cloud);
  file.text(std::string(has_colour ? "C" : "") + (has_normal ? "N" : "") + "OFF\n");
  writeComments(remarks, file);
  file.text(std::to_string(points) + " " + std::to_string(mesh.polygons.size()) +
            " 0\n");
  for (std::size_t i = 0; i < points; ++i) {
    writePosition(pointAt(cloud, i), columns, file);
    if (has_normal)
      writeFloats(pointAt(cloud, i) + normal, file);
    if (has_colour)
      writeColourBytes(pointAt(cloud, i) + colour, file);
    file.text("\n");
  }
  for (const pcl::Vertices& polygon : mesh.polygons)
    writeOffFace(polygon, file);
}

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
