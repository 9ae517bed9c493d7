// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reading raw clouds with unknown fields.
#include "mesh/cloud_access.h"

#include "mesh/cloud_fields.h"

#include <limits>

namespace pcl::ccaa {
namespace {

/** \brief Layout of three fields of equal floating type; nothing when they are not. */
bool
tripleLayout(const pcl::PCLPointCloud2& cloud,
             const std::array<const char*, 3>& names,
             TripleLayout& layout)
{
  const pcl::PCLPointField* first = findField(cloud, names[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const pcl::PCLPointField* field = findField(cloud, names[i]);
    if (field == nullptr || !isFloating(*field) || field->datatype != first->datatype)
      return false;
    layout.offsets[i] = field->offset;
  }
  layout.record_bytes = cloud.point_step;
  layout.is_double = first->datatype == pcl::PCLPointField::FLOAT64;
  layout.records_per_row = cloud.width;
  layout.row_padding_bytes =
      cloud.row_step - static_cast<std::size_t>(cloud.width) * cloud.point_step;
  return true;
}

PointView
tripleView(const pcl::PCLPointCloud2& cloud, const std::array<const char*, 3>& names)
{
  TripleLayout layout;
  if (pointCount(cloud) == 0 || !tripleLayout(cloud, names, layout))
    return {};
  return {cloud.data.data(), pointCount(cloud), layout};
}

CloudProblem
checkFields(const pcl::PCLPointCloud2& cloud)
{
  for (const char* name : {"x", "y", "z"})
    if (findField(cloud, name) == nullptr)
      return CloudProblem::NO_POSITION;
  TripleLayout unused;
  if (!tripleLayout(cloud, {"x", "y", "z"}, unused))
    return CloudProblem::POSITION_TYPE;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.offset + fieldBytes(field) > cloud.point_step)
      return CloudProblem::FIELD_OUTSIDE;
  return CloudProblem::NONE;
}

CloudProblem
checkSize(const pcl::PCLPointCloud2& cloud)
{
  const auto row_step = static_cast<std::size_t>(cloud.row_step);
  if (pointCount(cloud) > static_cast<std::size_t>(std::numeric_limits<index_t>::max()))
    return CloudProblem::TOO_MANY_POINTS;
  if (row_step < static_cast<std::size_t>(cloud.width) * cloud.point_step)
    return CloudProblem::ROW_TOO_SHORT;
  if (cloud.data.size() != row_step * cloud.height)
    return CloudProblem::DATA_SIZE;
  return CloudProblem::NONE;
}

} // namespace

const char*
describe(CloudProblem problem)
{
  switch (problem) {
  case CloudProblem::NONE:
    return "no problem";
  case CloudProblem::FOREIGN_BYTE_ORDER:
    return "the cloud has the byte order of another machine";
  case CloudProblem::NO_POSITION:
    return "the cloud has no fields x, y and z";
  case CloudProblem::POSITION_TYPE:
    return "the fields x, y and z are not all float or all double";
  case CloudProblem::FIELD_OUTSIDE:
    return "a field of the cloud ends beyond point_step";
  case CloudProblem::ROW_TOO_SHORT:
    return "row_step of the cloud is too small for its width";
  case CloudProblem::DATA_SIZE:
    return "the data of the cloud is not row_step * height bytes";
  case CloudProblem::TOO_MANY_POINTS:
    return "the cloud has more points than can be numbered";
  case CloudProblem::BAD_SOURCE:
    return "a new vertex refers to a point that is not in the cloud";
  }
  return "unknown problem";
}

CloudProblem
checkCloud(const pcl::PCLPointCloud2& cloud)
{
  const bool is_bigendian = cloud.is_bigendian != 0;
  if (is_bigendian != static_cast<bool>(BOOST_ENDIAN_BIG_BYTE))
    return CloudProblem::FOREIGN_BYTE_ORDER;
  const CloudProblem problem = checkFields(cloud);
  if (problem != CloudProblem::NONE || pointCount(cloud) == 0)
    return problem;
  return checkSize(cloud);
}

PointView
positionView(const pcl::PCLPointCloud2& cloud)
{
  return tripleView(cloud, {"x", "y", "z"});
}

PointView
normalView(const pcl::PCLPointCloud2& cloud)
{
  return tripleView(cloud, {"normal_x", "normal_y", "normal_z"});
}

PointView
viewpointView(const pcl::PCLPointCloud2& cloud)
{
  return tripleView(cloud, {"vp_x", "vp_y", "vp_z"});
}

PositionList
copyPositions(const PointView& view)
{
  PositionList list;
  list.positions.resize(view.size());
  for (std::size_t i = 0; i < view.size(); ++i) {
    list.positions[i] = view[i];
    if (list.positions[i].allFinite())
      continue;
    list.positions[i].setConstant(std::numeric_limits<double>::quiet_NaN());
    ++list.non_finite;
  }
  return list;
}

} // namespace pcl::ccaa
