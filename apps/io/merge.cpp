// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: several views of one object as one cloud.
#include "merge.h"

#include "cloud_normals.h"
#include "mesh/cloud_access.h"
#include "mesh/side_hints.h"
#include "point_columns.h"
#include "point_table.h"
#include "remarks.h"
#include "wording.h"

#include <algorithm>
#include <cstring>

namespace app {
namespace {

using Field = pcl::PCLPointField;

/** The field of \a cloud that holds the same as \a wanted, or null. */
const Field*
sameField(const pcl::PCLPointCloud2& cloud, const Field& wanted)
{
  for (const Field& field : cloud.fields) {
    const bool is_same = field.name == wanted.name &&
                         field.datatype == wanted.datatype &&
                         field.count == wanted.count;
    if (is_same || (isColour(field) && isColour(wanted)))
      return &field;
  }
  return nullptr;
}

bool
allHave(const std::vector<NamedModel>& parts, const Field& wanted)
{
  return std::all_of(parts.begin(), parts.end(), [&](const NamedModel& part) {
    return sameField(part.model.mesh.cloud, wanted) != nullptr;
  });
}

/** Names of the fields that not all parts have, each once. */
std::string
differingFields(const std::vector<NamedModel>& parts)
{
  std::vector<std::string> names;
  for (const NamedModel& part : parts)
    for (const Field& field : part.model.mesh.cloud.fields)
      if (field.name != "_" && !allHave(parts, field) &&
          std::find(names.begin(), names.end(), field.name) == names.end())
        names.push_back(field.name);
  std::string text;
  for (const std::string& name : names)
    addToList(text, name);
  return text;
}

/** The fields all parts have, as columns of the merged cloud. */
std::vector<SourceColumn>
commonColumns(const std::vector<NamedModel>& parts)
{
  std::vector<SourceColumn> columns;
  for (const Field& field : parts.front().model.mesh.cloud.fields)
    if (field.name != "_" && scalarSize(field.datatype) > 0 && allHave(parts, field))
      columns.push_back(
          {field.name, field.datatype, std::max<std::size_t>(field.count, 1)});
  return columns;
}

void
copyPoints(const pcl::PCLPointCloud2& from,
           std::size_t first,
           pcl::PCLPointCloud2& cloud)
{
  const std::size_t points = pointCount(from);
  if (points == 0)
    return; // nor may an offset be added to where they are
  for (const Field& field : cloud.fields) {
    const Field* const source = sameField(from, field);
    const std::size_t bytes = scalarSize(field.datatype) * field.count;
    std::uint8_t* target = cloud.data.data() + first * cloud.point_step + field.offset;
    for (std::size_t i = 0; i < points; ++i, target += cloud.point_step)
      std::memcpy(target, pointAt(from, i) + source->offset, bytes);
  }
}

bool
standTogether(const std::vector<NamedModel>& parts)
{
  const Viewpoint& first = parts.front().model.viewpoint;
  return std::all_of(parts.begin(), parts.end(), [&](const NamedModel& part) {
    const Viewpoint& other = part.model.viewpoint;
    return other.known == first.known && other.may_be_origin == first.may_be_origin &&
           other.position == first.position;
  });
}

/** Each point gets the viewpoint of its file, or the whole the one of all. */
void
shareViewpoints(std::vector<NamedModel>& parts, Model& whole)
{
  if (standTogether(parts)) {
    whole.viewpoint = parts.front().model.viewpoint;
    return;
  }
  for (NamedModel& part : parts)
    if (part.model.viewpoint.may_be_origin)
      part.model.viewpoint.known =
          pcl::ccaa::liesBeforeOrigin(pcl::ccaa::positionView(part.model.mesh.cloud));
  const auto is_known = [](const NamedModel& part) {
    return part.model.viewpoint.known;
  };
  const bool all_known = std::all_of(parts.begin(), parts.end(), is_known);
  if (!all_known && std::any_of(parts.begin(), parts.end(), is_known))
    whole.warnings.push_back(
        "the sensor's place is not told by all clouds; none is used");
  const bool as_double =
      std::any_of(parts.begin(), parts.end(), [](const NamedModel& part) {
        return needsDouble(part.model.viewpoint);
      });
  for (NamedModel& part : parts)
    if (all_known)
      appendViewpoint(part.model.viewpoint, part.model.mesh.cloud, as_double);
}

/** Doubles for all parts where one has them. */
void
alignPositions(std::vector<NamedModel>& parts)
{
  const auto has_doubles = [](const NamedModel& part) {
    return hasDoublePositions(part.model.mesh.cloud);
  };
  if (std::none_of(parts.begin(), parts.end(), has_doubles))
    return;
  for (NamedModel& part : parts)
    if (!has_doubles(part))
      pcl::GlobalShift().toGlobal(pcl::PCLPointCloud2(part.model.mesh.cloud),
                                  part.model.mesh.cloud);
}

void
addNew(const std::vector<std::string>& more, std::vector<std::string>& lines)
{
  for (const std::string& line : more)
    if (std::find(lines.begin(), lines.end(), line) == lines.end())
      lines.push_back(line);
}

void
mergeRemarks(const std::vector<NamedModel>& parts, Model& whole)
{
  const std::string units = namedUnits(parts.front().model.remarks);
  bool units_differ = false;
  for (const NamedModel& part : parts) {
    const Remarks& remarks = part.model.remarks;
    units_differ = units_differ || namedUnits(remarks) != units;
    addNew(remarks.comments, whole.remarks.comments);
    addNew(remarks.infos, whole.remarks.infos);
    if (whole.remarks.title.empty())
      whole.remarks.title = remarks.title;
    for (const std::string& warning : part.model.warnings)
      whole.warnings.push_back(part.name + ": " + warning);
  }
  if (units_differ)
    whole.warnings.push_back(
        "not all clouds name the same units; coordinates are taken as they are");
}

} // namespace

void
conformTo(const pcl::PCLPointCloud2& layout,
          const Viewpoint& viewpoint,
          pcl::PCLPointCloud2& cloud)
{
  if (findField(layout, "vp_x") != nullptr)
    appendViewpoint(
        viewpoint, cloud, findField(layout, "vp_x", Field::FLOAT64) != nullptr);
  if (hasDoublePositions(layout) && !hasDoublePositions(cloud))
    pcl::GlobalShift().toGlobal(pcl::PCLPointCloud2(cloud), cloud);
  pcl::PCLPointCloud2 whole = layout;
  whole.width = cloud.width * cloud.height;
  whole.height = 1;
  whole.row_step = whole.width * whole.point_step;
  whole.data.assign(whole.row_step, 0);
  copyPoints(cloud, 0, whole);
  cloud = std::move(whole);
}

void
mergeModels(std::vector<NamedModel>& parts, Model& whole)
{
  if (parts.size() == 1) {
    whole = std::move(parts.front().model);
    return;
  }
  mergeRemarks(parts, whole);
  alignPositions(parts);
  shareViewpoints(parts, whole);
  const std::string differing = differingFields(parts);
  if (!differing.empty())
    whole.warnings.push_back("not all clouds have the fields " + differing +
                             " in the same type; they are left out");
  std::size_t points = 0;
  for (const NamedModel& part : parts)
    points += pointCount(part.model.mesh.cloud);
  pcl::PCLPointCloud2& cloud = whole.mesh.cloud;
  try {
    allocateCloud(planTable(commonColumns(parts), Naming::PCL), points, cloud);
  }
  catch (const Failure& failure) {
    throw Failure(std::string("the clouds cannot be merged: ") + failure.what());
  }
  std::size_t first = 0;
  for (NamedModel& part : parts) {
    copyPoints(part.model.mesh.cloud, first, cloud);
    first += pointCount(part.model.mesh.cloud);
    cloud.is_dense = cloud.is_dense && part.model.mesh.cloud.is_dense;
    part.model.mesh.cloud.data =
        std::vector<std::uint8_t>(); // {} would keep the memory
  }
  whole.shift = pcl::GlobalShift::of(cloud);
}

} // namespace app
