// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes binary PLY with all fields.
#include "ply_camera.h"
#include "point_columns.h"
#include "remarks.h"
#include "writers.h"

#include <algorithm>

namespace app {
namespace {

using Field = pcl::ccaa::PointFieldNames;

/** PLY's name for a type; 64-bit whole numbers are written as doubles. */
std::string
plyTypeName(ScalarType type)
{
  switch (type) {
  case Field::INT8:
    return "char";
  case Field::BOOL:
  case Field::UINT8:
    return "uchar";
  case Field::INT16:
    return "short";
  case Field::UINT16:
    return "ushort";
  case Field::INT32:
    return "int";
  case Field::UINT32:
    return "uint";
  case Field::FLOAT32:
    return "float";
  default:
    return "double";
  }
}

bool
isWide(ScalarType type)
{
  return type == Field::INT64 || type == Field::UINT64;
}

void
writeRemarks(const Remarks& remarks, OutputFile& file)
{
  file.text("comment " + std::string(our_mark) + "\n");
  if (!remarks.title.empty())
    file.text("comment " + remarks.title + "\n");
  for (const std::string& line : remarks.comments)
    file.text("comment " + line + "\n");
  for (const std::string& line : remarks.infos)
    file.text("obj_info " + line + "\n");
}

void
writeHeader(const pcl::PolygonMesh& mesh,
            const std::vector<PointColumn>& columns,
            const FileExtras& extras,
            const char* faces, // type of the corner count; null for a cloud
            OutputFile& file)
{
  file.text("ply\nformat binary_little_endian 1.0\n");
  writeRemarks(extras.remarks, file);
  file.text("element vertex " + std::to_string(pointCount(mesh.cloud)) + "\n");
  for (const PointColumn& column : columns)
    file.text("property " + plyTypeName(column.type) + " " + column.name + "\n");
  if (extras.viewpoint.isTold())
    announceCamera(extras.viewpoint, file);
  if (faces) {
    file.text("element face " + std::to_string(mesh.polygons.size()) + "\n");
    file.text("property list " + std::string(faces) + " int vertex_indices\n");
    for (const FaceProperty& property : extras.properties)
      file.text("property int " + property.name + "\n");
  }
  file.text("end_header\n");
}

void
writePoints(const pcl::PCLPointCloud2& cloud,
            const std::vector<PointColumn>& columns,
            OutputFile& file)
{
  const std::size_t points = pointCount(cloud);
  for (std::size_t i = 0; i < points; ++i) {
    const std::uint8_t* const point = pointAt(cloud, i);
    for (const PointColumn& column : columns) {
      const std::uint8_t* const value = point + column.offset;
      if (isWide(column.type)) {
        const auto real = loadScalarAs<double>(value, column.type, false);
        file.write(&real, sizeof(real));
      }
      else
        file.write(value, scalarSize(column.type));
    }
  }
}

void
writeFaces(const pcl::PolygonMesh& mesh,
           const std::vector<FaceProperty>& properties,
           bool wide_count,
           OutputFile& file)
{
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const auto& corners = mesh.polygons[i].vertices;
    const auto count = static_cast<std::int32_t>(corners.size());
    const auto byte = static_cast<std::uint8_t>(corners.size());
    if (wide_count)
      file.write(&count, sizeof(count));
    else
      file.write(&byte, sizeof(byte));
    static_assert(sizeof(pcl::index_t) == sizeof(std::int32_t), "PLY indices are int");
    file.write(corners.data(), corners.size() * sizeof(pcl::index_t));
    for (const FaceProperty& property : properties)
      file.write(&property.values[i], sizeof(property.values[i]));
  }
}

} // namespace

void
writePly(const pcl::PolygonMesh& mesh,
         const FileExtras& extras,
         bool with_faces,
         OutputFile& file)
{
  const std::vector<PointColumn> columns = listColumns(mesh.cloud);
  const bool wide_count =
      std::any_of(mesh.polygons.begin(), mesh.polygons.end(), [](const auto& polygon) {
        return polygon.vertices.size() > 255;
      });
  const char* const count_type = wide_count ? "int" : "uchar";
  writeHeader(mesh, columns, extras, with_faces ? count_type : nullptr, file);
  writePoints(mesh.cloud, columns, file);
  if (extras.viewpoint.isTold())
    writeCamera(extras.viewpoint, mesh.cloud, file);
  if (with_faces)
    writeFaces(mesh, extras.properties, wide_count, file);
}

} // namespace app
