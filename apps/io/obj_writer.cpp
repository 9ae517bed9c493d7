// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes Wavefront OBJ.
#include "mesh_writers.h"
#include "point_columns.h"
#include "remarks.h"

#include <array>

namespace app {
namespace {

void
writePosition(const std::uint8_t* point,
              const std::array<PointColumn, 3>& axes,
              OutputFile& file)
{
  for (const PointColumn& axis : axes) {
    file.text(" ");
    writeAsText(point, axis, file);
  }
}

/** Shares of one, which six digits bring back to the same byte. */
void
writeColour(const std::uint8_t* colour, OutputFile& file)
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
writeFace(const pcl::Vertices& polygon, bool has_normal, OutputFile& file)
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

} // namespace

void
writeObj(const pcl::PolygonMesh& mesh, const Remarks& remarks, OutputFile& file)
{
  const pcl::PCLPointCloud2& cloud = mesh.cloud;
  const std::vector<PointColumn> columns = listColumns(cloud);
  const std::array<PointColumn, 3> axes = {columns.at(0), columns.at(1), columns.at(2)};
  std::size_t colour = 0;
  std::size_t normal = 0;
  const bool has_colour = findColour(cloud, colour);
  const bool has_normal = findNormal(cloud, normal);
  const std::size_t points = pointCount(cloud);
  for (const std::string& line : asComments(remarks))
    file.text("# " + line + "\n");
  for (std::size_t i = 0; i < points; ++i) {
    file.text("v");
    writePosition(pointAt(cloud, i), axes, file);
    if (has_colour)
      writeColour(pointAt(cloud, i) + colour, file);
    file.text("\n");
  }
  for (std::size_t i = 0; has_normal && i < points; ++i) {
    file.text("vn");
    writeFloats(pointAt(cloud, i) + normal, file);
    file.text("\n");
  }
  for (const pcl::Vertices& polygon : mesh.polygons)
    writeFace(polygon, has_normal, file);
}

} // namespace app
