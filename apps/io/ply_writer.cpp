// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes binary PLY with all fields.
#include "cloud_normals.h"
#include "mesh_writers.h"
#include "point_columns.h"
#include "remarks.h"

#include <algorithm>
#include <array>
#include <string_view>

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

/** Numbers of the camera by the names that PCL reads, in its order. */
constexpr std::array<const char*, 14> CAMERA_NUMBERS{"view_px",
                                                     "view_py",
                                                     "view_pz",
                                                     "x_axisx",
                                                     "x_axisy",
                                                     "x_axisz",
                                                     "y_axisx",
                                                     "y_axisy",
                                                     "y_axisz",
                                                     "z_axisx",
                                                     "z_axisy",
                                                     "z_axisz",
                                                     "viewportx",
                                                     "viewporty"};

bool
isWhole(std::string_view name)
{
  return name == "viewportx" || name == "viewporty";
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

/** PCL reads floats; of places that floats do not hold it would read nonsense. */
bool
isDouble(std::string_view name, const Viewpoint& viewpoint)
{
  return name.substr(0, 6) == "view_p" && needsDouble(viewpoint);
}

void
announceCamera(const Viewpoint& viewpoint, OutputFile& file)
{
  file.text("element camera 1\n");
  for (const std::string name : CAMERA_NUMBERS)
    file.text("property " +
              std::string(isWhole(name)               ? "int "
                          : isDouble(name, viewpoint) ? "double "
                                                      : "float ") +
              name + "\n");
}

/** The axes are the rows of the rotation, as PCL writes them. Like PCL, the size of the
 * picture stands for that of an organised cloud. */
void
writeCamera(const Viewpoint& viewpoint,
            const pcl::PCLPointCloud2& cloud,
            OutputFile& file)
{
  const Eigen::Matrix3f axes = viewpoint.orientation.toRotationMatrix();
  std::vector<double> numbers(viewpoint.position.data(), viewpoint.position.data() + 3);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      numbers.push_back(double{axes(row, column)});
  numbers.resize(CAMERA_NUMBERS.size(), 0.0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view name = CAMERA_NUMBERS[i];
    const auto size =
        static_cast<std::int32_t>(name == "viewportx" ? cloud.width : cloud.height);
    const auto single = static_cast<float>(numbers[i]);
    if (isWhole(name))
      file.write(&size, sizeof(size));
    else if (isDouble(name, viewpoint))
      file.write(&numbers[i], sizeof(double));
    else
      file.write(&single, sizeof(single));
  }
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
