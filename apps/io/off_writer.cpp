// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes OFF.
#include "mesh_writers.h"
#include "point_columns.h"
#include "remarks.h"

namespace app {
namespace {

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
writeFace(const pcl::Vertices& polygon, OutputFile& file)
{
  file.number(polygon.vertices.size());
  for (const pcl::index_t corner : polygon.vertices) {
    file.text(" ");
    file.number(corner);
  }
  file.text("\n");
}

} // namespace

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
  for (const std::string& line : asComments(remarks))
    file.text("# " + line + "\n");
  file.text(std::to_string(points) + " " + std::to_string(mesh.polygons.size()) +
            " 0\n");
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      file.text(axis == 0 ? "" : " ");
      writeAsText(pointAt(cloud, i), columns.at(axis), file);
    }
    if (has_normal)
      writeFloats(pointAt(cloud, i) + normal, file);
    if (has_colour)
      writeColourBytes(pointAt(cloud, i) + colour, file);
    file.text("\n");
  }
  for (const pcl::Vertices& polygon : mesh.polygons)
    writeFace(polygon, file);
}

} // namespace app
