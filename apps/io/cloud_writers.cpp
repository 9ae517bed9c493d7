// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds in PCL's own format and as text.
#include "point_columns.h"
#include "remarks.h"
#include "writers.h"

#include <algorithm>

namespace app {
namespace {

using Field = pcl::PCLPointField;
using FieldNames = pcl::ccaa::PointFieldNames;

char
pcdKind(ScalarType type)
{
  switch (type) {
  case Field::INT8:
  case Field::INT16:
  case Field::INT32:
  case FieldNames::INT64:
    return 'I';
  case Field::FLOAT32:
  case Field::FLOAT64:
    return 'F';
  default:
    return 'U';
  }
}

void
writeFields(const std::vector<Field>& fields, OutputFile& file)
{
  std::string names;
  std::string sizes;
  std::string kinds;
  std::string counts;
  for (const Field& field : fields) {
    std::string name = field.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    names += " " + name;
    sizes += " " + std::to_string(scalarSize(field.datatype));
    kinds += std::string(" ") + pcdKind(field.datatype);
    counts += " " + std::to_string(countOf(field));
  }
  file.text("FIELDS" + names + "\nSIZE" + sizes + "\nTYPE" + kinds + "\nCOUNT" +
            counts);
}

void
writeViewpoint(const Viewpoint& viewpoint, OutputFile& file)
{
  const Eigen::Quaternionf& q = viewpoint.orientation;
  file.text("VIEWPOINT");
  for (const double value : viewpoint.position) {
    file.text(" ");
    file.number(value);
  }
  for (const float value : {q.w(), q.x(), q.y(), q.z()}) {
    file.text(" ");
    file.number(value);
  }
}

} // namespace

void
writePcd(const pcl::PCLPointCloud2& cloud, const FileExtras& extras, OutputFile& file)
{
  std::vector<Field> fields;
  for (const Field& field : cloud.fields)
    if (field.name != "_" && scalarSize(field.datatype) > 0)
      fields.push_back(field);
  const std::size_t points = pointCount(cloud);
  file.text("# .PCD v0.7 - Point Cloud Data file format\n");
  writeComments(extras.remarks, file);
  file.text("VERSION 0.7\n");
  writeFields(fields, file);
  file.text("\nWIDTH " + std::to_string(cloud.width) + "\nHEIGHT " +
            std::to_string(cloud.height) + "\n");
  writeViewpoint(extras.viewpoint, file);
  file.text("\nPOINTS " + std::to_string(points) + "\nDATA binary\n");
  for (std::size_t i = 0; i < points; ++i)
    for (const Field& field : fields)
      file.write(pointAt(cloud, i) + field.offset,
                 scalarSize(field.datatype) * countOf(field));
}

void
writeXyz(const pcl::PCLPointCloud2& cloud, const Remarks& remarks, OutputFile& file)
{
  const std::vector<PointColumn> columns = listColumns(cloud);
  writeComments(remarks, file);
  file.text("#");
  for (const PointColumn& column : columns)
    file.text(" " + column.name);
  file.text("\n");
  const std::size_t points = pointCount(cloud);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      writeAsText(pointAt(cloud, i), columns[c], file);
      file.text(c + 1 < columns.size() ? " " : "\n");
    }
}

} // namespace app
