// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes legacy binary VTK with all fields.
#include "mesh/cloud_access.h"
#include "point_columns.h"
#include "remarks.h"
#include "writers.h"

#include <algorithm>

namespace app {
namespace {

using Field = pcl::PCLPointField;
using FieldNames = pcl::ccaa::PointFieldNames;

const char*
vtkTypeName(ScalarType type)
{
  switch (type) {
  case Field::INT8:
    return "char";
  case FieldNames::BOOL:
  case Field::UINT8:
    return "unsigned_char";
  case Field::INT16:
    return "short";
  case Field::UINT16:
    return "unsigned_short";
  case Field::INT32:
    return "int";
  case Field::UINT32:
    return "unsigned_int";
  case FieldNames::INT64:
    return "vtktypeint64";
  case FieldNames::UINT64:
    return "vtktypeuint64";
  case Field::FLOAT32:
    return "float";
  default:
    return "double";
  }
}

/** One column of all points, in VTK's byte order. */
void
writeColumn(const pcl::PCLPointCloud2& cloud,
            std::size_t offset,
            std::size_t count,
            ScalarType type,
            OutputFile& file)
{
  const std::size_t points = pointCount(cloud);
  visitScalar(type, [&](auto tag) {
    using T = typename decltype(tag)::type;
    for (std::size_t i = 0; i < points; ++i)
      for (std::size_t k = 0; k < count; ++k)
        file.bigEndian(
            loadScalar<T>(pointAt(cloud, i) + offset + k * sizeof(T), false));
  });
  file.text("\n");
}

void
writePositions(const pcl::PCLPointCloud2& cloud, OutputFile& file)
{
  const bool is_double = hasDoublePositions(cloud);
  file.text("POINTS " + std::to_string(pointCount(cloud)) +
            (is_double ? " double\n" : " float\n"));
  const auto view = pcl::ccaa::positionView(cloud);
  for (std::size_t i = 0; i < view.size(); ++i)
    for (const double coordinate : view[i])
      if (is_double)
        file.bigEndian(coordinate);
      else
        file.bigEndian(static_cast<float>(coordinate));
  file.text("\n");
}

/** Polygons or lines, whichever \a keyword says they are. */
void
writeCells(const std::string& keyword,
           const std::vector<pcl::Vertices>& cells,
           OutputFile& file)
{
  std::size_t size = 0;
  for (const auto& cell : cells)
    size += cell.vertices.size() + 1;
  file.text(keyword + " " + std::to_string(cells.size()) + " " + std::to_string(size) +
            "\n");
  for (const auto& cell : cells) {
    file.bigEndian(static_cast<std::int32_t>(cell.vertices.size()));
    for (const pcl::index_t corner : cell.vertices)
      file.bigEndian(static_cast<std::int32_t>(corner));
  }
  file.text("\n");
}

void
writeHeader(const Remarks& remarks, OutputFile& file)
{
  file.text("# vtk DataFile Version 3.0\n" + asTitle(remarks) +
            "\nBINARY\nDATASET POLYDATA\n");
}

void
writeColours(const pcl::PCLPointCloud2& cloud, std::size_t offset, OutputFile& file)
{
  file.text("COLOR_SCALARS RGB 3\n"); // the name PCL looks for
  const std::size_t points = pointCount(cloud);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t byte = 3; byte-- > 0;)
      file.write(pointAt(cloud, i) + offset + byte, 1);
  file.text("\n");
}

/** Fields that have no section of their own in VTK. */
std::vector<Field>
otherFields(const pcl::PCLPointCloud2& cloud, bool has_colour, bool has_normal)
{
  std::vector<Field> others;
  for (const Field& field : cloud.fields) {
    const std::string& name = field.name;
    const bool is_position = name == "x" || name == "y" || name == "z";
    const bool is_colour = has_colour && (name == "rgb" || name == "rgba");
    const bool is_normal = has_normal && name.substr(0, 7) == "normal_" &&
                           name.size() == 8 && name[7] >= 'x' && name[7] <= 'z';
    if (!is_position && !is_colour && !is_normal && name != "_" &&
        scalarSize(field.datatype) > 0)
      others.push_back(field);
  }
  return others;
}

void
writePointData(const pcl::PCLPointCloud2& cloud, OutputFile& file)
{
  std::size_t colour = 0;
  std::size_t normal = 0;
  const bool has_colour = findColour(cloud, colour);
  const bool has_normal = findNormal(cloud, normal);
  const std::vector<Field> others = otherFields(cloud, has_colour, has_normal);
  if (!has_colour && !has_normal && others.empty())
    return;
  file.text("POINT_DATA " + std::to_string(pointCount(cloud)) + "\n");
  if (has_colour)
    writeColours(cloud, colour, file);
  if (has_normal) {
    file.text("NORMALS normal float\n");
    writeColumn(cloud, normal, 3, Field::FLOAT32, file);
  }
  if (others.empty())
    return;
  file.text("FIELD fields " + std::to_string(others.size()) + "\n");
  for (Field field : others) {
    std::replace(field.name.begin(), field.name.end(), ' ', '_');
    const std::size_t count = field.count == 0 ? 1 : field.count;
    file.text(field.name + " " + std::to_string(count) + " " +
              std::to_string(pointCount(cloud)) + " " + vtkTypeName(field.datatype) +
              "\n");
    writeColumn(cloud, field.offset, count, field.datatype, file);
  }
}

/** \brief The points of no polygon, a cell each: without one a viewer does not draw
 * them.
 */
std::vector<pcl::Vertices>
freePoints(const pcl::PolygonMesh& mesh)
{
  std::vector<bool> is_free(pointCount(mesh.cloud), true);
  for (const auto& polygon : mesh.polygons)
    for (const pcl::index_t corner : polygon.vertices)
      is_free[static_cast<std::size_t>(corner)] = false;
  std::vector<pcl::Vertices> dots;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) {
      dots.emplace_back();
      dots.back().vertices.push_back(static_cast<pcl::index_t>(i));
    }
  return dots;
}

} // namespace

void
writeVtk(const pcl::PolygonMesh& mesh, const FileExtras& extras, OutputFile& file)
{
  writeHeader(extras.remarks, file);
  writePositions(mesh.cloud, file);
  const std::vector<pcl::Vertices> dots = freePoints(mesh);
  if (!dots.empty())
    writeCells("VERTICES", dots, file);
  writeCells("POLYGONS", mesh.polygons, file);
  if (!extras.properties.empty())
    file.text("CELL_DATA " + std::to_string(dots.size() + mesh.polygons.size()) + "\n");
  for (const FaceProperty& property : extras.properties) {
    file.text("SCALARS " + property.name + " int 1\nLOOKUP_TABLE default\n");
    for (std::size_t i = 0; i < dots.size(); ++i)
      file.bigEndian(std::int32_t{-1});
    for (const std::int32_t value : property.values)
      file.bigEndian(value);
    file.text("\n");
  }
  writePointData(mesh.cloud, file);
}

void
writeVtkLines(const pcl::PCLPointCloud2& cloud,
              const std::vector<pcl::Vertices>& lines,
              OutputFile& file)
{
  writeHeader({}, file);
  writePositions(cloud, file);
  writeCells("LINES", lines, file);
  writePointData(cloud, file);
}

} // namespace app
