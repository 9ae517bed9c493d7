// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes binary PLY with all fields.
#include "ply_camera.h"
#include "point_columns.h"
#include "remarks.h"
#include "writers.h"

#include <algorithm>
#include <limits>

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

} // namespace

PlyParts::PlyParts(const pcl::PCLPointCloud2& layout,
                   const PlyCounts& counts,
                   const FileExtras& extras,
                   OutputFile& file)
: columns_(listColumns(layout)), wide_count_(counts.wide), file_(file)
{
  // int, as all programs expect it, as long as that is enough.
  const bool needs_unsigned =
      counts.vertices > std::size_t{std::numeric_limits<std::int32_t>::max()};
  file.text("ply\nformat binary_little_endian 1.0\n");
  writeRemarks(extras.remarks, file);
  file.text("element vertex " + std::to_string(counts.vertices) + "\n");
  for (const PointColumn& column : columns_)
    file.text("property " + plyTypeName(column.type) + " " + column.name + "\n");
  if (extras.viewpoint.isTold())
    announceCamera(extras.viewpoint, file);
  if (!counts.has_faces) {
    file.text("end_header\n");
    return;
  }
  file.text("element face " + std::to_string(counts.faces) + "\n");
  file.text(std::string("property list ") + (counts.wide ? "int" : "uchar") +
            (needs_unsigned ? " uint" : " int") + " vertex_indices\n");
  for (const FaceProperty& property : extras.properties)
    file.text("property int " + property.name + "\n");
  file.text("end_header\n");
}

void
PlyParts::points(const pcl::PCLPointCloud2& cloud)
{
  const std::size_t points = pointCount(cloud);
  for (std::size_t i = 0; i < points; ++i) {
    const std::uint8_t* const point = pointAt(cloud, i);
    for (const PointColumn& column : columns_) {
      const std::uint8_t* const value = point + column.offset;
      if (isWide(column.type)) {
        const auto real = loadScalarAs<double>(value, column.type, false);
        file_.write(&real, sizeof(real));
      }
      else
        file_.write(value, scalarSize(column.type));
    }
  }
}

void
PlyParts::faceBytes(const void* corners, std::size_t count)
{
  const auto wide = static_cast<std::int32_t>(count);
  const auto byte = static_cast<std::uint8_t>(count);
  if (wide_count_)
    file_.write(&wide, sizeof(wide));
  else
    file_.write(&byte, sizeof(byte));
  file_.write(corners, count * sizeof(std::int32_t));
}

void
writePly(const pcl::PolygonMesh& mesh,
         const FileExtras& extras,
         bool with_faces,
         OutputFile& file)
{
  static_assert(sizeof(pcl::index_t) == sizeof(std::int32_t), "PLY indices are int");
  PlyCounts counts;
  counts.vertices = pointCount(mesh.cloud);
  counts.faces = mesh.polygons.size();
  counts.has_faces = with_faces;
  counts.wide =
      std::any_of(mesh.polygons.begin(), mesh.polygons.end(), [](const auto& polygon) {
        return polygon.vertices.size() > 255;
      });
  PlyParts parts(mesh.cloud, counts, extras, file);
  parts.points(mesh.cloud);
  if (extras.viewpoint.isTold())
    writeCamera(extras.viewpoint, mesh.cloud, file);
  for (std::size_t i = 0; with_faces && i < mesh.polygons.size(); ++i) {
    parts.faceBytes(mesh.polygons[i].vertices.data(), mesh.polygons[i].vertices.size());
    for (const FaceProperty& property : extras.properties)
      file.write(&property.values[i], sizeof(property.values[i]));
  }
}

} // namespace app
