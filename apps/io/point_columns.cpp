// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fields of a cloud as single columns for writing.
#include "point_columns.h"

#include "text_scanner.h"

#include <algorithm>
#include <set>

namespace app {
namespace {

using Field = pcl::PCLPointField;

void
addColour(const Field& field, std::vector<PointColumn>& columns)
{
  const char* const names[] = {"red", "green", "blue", "alpha"};
  const std::size_t bytes[] = {2, 1, 0, 3};
  const std::size_t parts = field.name == "rgba" ? 4 : 3;
  for (std::size_t i = 0; i < parts; ++i)
    columns.push_back({names[i], Field::UINT8, field.offset + bytes[i]});
}

std::string
writtenName(const Field& field)
{
  if (field.name == "normal_x" || field.name == "normal_y" || field.name == "normal_z")
    return "n" + field.name.substr(7);
  std::string name = field.name.empty() ? "field" : field.name;
  std::replace_if(name.begin(), name.end(), TextScanner::isSpace, '_');
  return name;
}

void
addPlain(const Field& field, std::vector<PointColumn>& columns)
{
  const std::string name = writtenName(field);
  const std::size_t count = countOf(field);
  const std::size_t bytes = scalarSize(field.datatype);
  for (std::size_t i = 0; bytes > 0 && i < count; ++i)
    columns.push_back({count == 1 ? name : name + "_" + std::to_string(i),
                       field.datatype,
                       field.offset + i * bytes});
}

void
makeNamesUnique(std::vector<PointColumn>& columns)
{
  std::set<std::string> used;
  for (PointColumn& column : columns)
    while (!used.insert(column.name).second)
      column.name += "_";
}

bool
isPosition(const PointColumn& column)
{
  return column.name == "x" || column.name == "y" || column.name == "z";
}

} // namespace

bool
isColour(const Field& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         scalarSize(field.datatype) == 4 && countOf(field) == 1;
}

const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& cloud, const std::string& name, ScalarType type)
{
  for (const Field& field : cloud.fields)
    if (field.name == name && countOf(field) == 1 &&
        (type == 0 || field.datatype == type))
      return &field;
  return nullptr;
}

bool
findColour(const pcl::PCLPointCloud2& cloud, std::size_t& offset)
{
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(), isColour);
  if (found == cloud.fields.end())
    return false;
  offset = found->offset;
  return true;
}

bool
findNormal(const pcl::PCLPointCloud2& cloud, std::size_t& offset)
{
  const Field* const x = findField(cloud, "normal_x", Field::FLOAT32);
  const Field* const y = findField(cloud, "normal_y", Field::FLOAT32);
  const Field* const z = findField(cloud, "normal_z", Field::FLOAT32);
  if (!x || !y || !z || y->offset != x->offset + 4 || z->offset != x->offset + 8)
    return false;
  offset = x->offset;
  return true;
}

std::vector<PointColumn>
listColumns(const pcl::PCLPointCloud2& cloud)
{
  std::vector<PointColumn> columns;
  for (const Field& field : cloud.fields) {
    if (isColour(field))
      addColour(field, columns);
    else if (field.name != "_")
      addPlain(field, columns);
  }
  makeNamesUnique(columns);
  std::stable_partition(columns.begin(), columns.end(), isPosition);
  return columns;
}

std::vector<Eigen::Vector3f>
readPositions(const pcl::PCLPointCloud2& cloud, const pcl::GlobalShift& shift)
{
  const std::size_t points = pointCount(cloud);
  std::vector<Eigen::Vector3f> positions(points, Eigen::Vector3f::Zero());
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    if (const Field* const field = findField(cloud, names[axis]))
      for (std::size_t i = 0; i < points; ++i)
        positions[i][axis] = static_cast<float>(
            loadScalarAs<double>(
                pointAt(cloud, i) + field->offset, field->datatype, false) -
            shift.offset()[axis]);
  return positions;
}

bool
hasDoublePositions(const pcl::PCLPointCloud2& cloud)
{
  return findField(cloud, "x", Field::FLOAT64) != nullptr;
}

void
writeAsText(const std::uint8_t* point, const PointColumn& column, OutputFile& file)
{
  visitScalar(column.type, [&](auto tag) {
    file.number(loadScalar<typename decltype(tag)::type>(point + column.offset, false));
  });
}

void
writeFloats(const std::uint8_t* first, OutputFile& file)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    file.text(" ");
    file.number(loadScalar<float>(first + axis * sizeof(float), false));
  }
}

} // namespace app
