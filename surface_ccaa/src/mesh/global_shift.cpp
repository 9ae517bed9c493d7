// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: coordinates too large for floats, such as those of maps.
#include <pcl/console/print.h>
#include <pcl/surface_ccaa/global_shift.h>

#include "mesh/cloud_access.h"
#include "mesh/cloud_extent.h"
#include "mesh/cloud_fields.h"

#include <cmath>
#include <cstring>

namespace pcl {
namespace {

using ccaa::CloudProblem;

/** Rounding to float may move a point by this share of the spacing. */
constexpr double FLOAT_ROUNDING_SHARE = 1e-3;

/** \brief Whole powers of ten, and powers of two below 1: what is taken off a double by
 * a multiple of these leaves all its digits. */
double
roundUnit(double side)
{
  return side >= 1.0 ? std::pow(10.0, std::floor(std::log10(side)))
                     : std::exp2(std::floor(std::log2(side)));
}

/** \brief Of a coordinate that the offset applies to; -1 for any other field. */
int
shiftedAxis(const pcl::PCLPointField& field)
{
  const std::string& name = field.name;
  const bool is_moved =
      name.size() == 1 || (name.size() == 4 && name.compare(0, 3, "vp_") == 0);
  const char axis = name.empty() ? ' ' : name.back();
  return is_moved && axis >= 'x' && axis <= 'z' && ccaa::isFloating(field) ? axis - 'x'
                                                                           : -1;
}

double
readReal(const pcl::PCLPointField& field, const std::uint8_t* record)
{
  float single = 0.0F;
  double value = 0.0;
  if (field.datatype == pcl::PCLPointField::FLOAT64)
    std::memcpy(&value, record + field.offset, sizeof(value));
  else
    std::memcpy(&single, record + field.offset, sizeof(single));
  return field.datatype == pcl::PCLPointField::FLOAT64 ? value : double{single};
}

void
writeReal(const pcl::PCLPointField& field, double value, std::uint8_t* record)
{
  const auto single = static_cast<float>(value);
  if (field.datatype == pcl::PCLPointField::FLOAT64)
    std::memcpy(record + field.offset, &value, sizeof(value));
  else
    std::memcpy(record + field.offset, &single, sizeof(single));
}

const std::uint8_t*
recordAt(const pcl::PCLPointCloud2& cloud, std::size_t point)
{
  return cloud.data.data() + point / cloud.width * cloud.row_step +
         point % cloud.width * cloud.point_step;
}

/** \brief Header, size and fields; moved coordinates are of \a type. */
pcl::PCLPointCloud2
withFields(const pcl::PCLPointCloud2& cloud, std::uint8_t type)
{
  pcl::PCLPointCloud2 packed;
  packed.header = cloud.header;
  packed.width = cloud.width;
  packed.height = cloud.height;
  packed.is_bigendian = cloud.is_bigendian;
  packed.is_dense = cloud.is_dense;
  std::size_t size = 0;
  for (pcl::PCLPointField field : cloud.fields) {
    if (shiftedAxis(field) >= 0)
      field.datatype = type;
    const auto bytes =
        static_cast<std::size_t>(std::max(pcl::getFieldSize(field.datatype), 1));
    size = (size + bytes - 1) / bytes * bytes;
    field.offset = static_cast<uindex_t>(size);
    size += ccaa::fieldBytes(field);
    packed.fields.push_back(field);
  }
  constexpr std::size_t ALIGNMENT = sizeof(double);
  size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  packed.point_step = static_cast<uindex_t>(size);
  packed.row_step = static_cast<uindex_t>(size * cloud.width);
  packed.data.assign(size * ccaa::pointCount(cloud), 0);
  return packed;
}

/** \brief A cloud that has its coordinates as \a type, with \a offset on top. */
pcl::PCLPointCloud2
movedCloud(const pcl::PCLPointCloud2& cloud,
           std::uint8_t type,
           const Eigen::Vector3d& offset)
{
  pcl::PCLPointCloud2 moved = withFields(cloud, type);
  for (std::size_t i = 0; i < ccaa::pointCount(cloud); ++i) {
    const std::uint8_t* const from = recordAt(cloud, i);
    std::uint8_t* const to = moved.data.data() + i * moved.point_step;
    for (std::size_t f = 0; f < cloud.fields.size(); ++f) {
      const pcl::PCLPointField& field = cloud.fields[f];
      const int axis = shiftedAxis(field);
      if (axis < 0)
        std::memcpy(
            to + moved.fields[f].offset, from + field.offset, ccaa::fieldBytes(field));
      else
        writeReal(moved.fields[f], readReal(field, from) + offset[axis], to);
    }
  }
  return moved;
}

/** \brief Where a field of the same kind is in another cloud; null where there is none.
 */
const pcl::PCLPointField*
counterpart(const pcl::PCLPointField& field, const pcl::PCLPointCloud2& cloud)
{
  const pcl::PCLPointField* const other = ccaa::findField(cloud, field.name);
  const bool fits = other != nullptr &&
                    ccaa::valueCount(*other) == ccaa::valueCount(field) &&
                    (other->datatype == field.datatype || shiftedAxis(*other) >= 0);
  return fits ? other : nullptr;
}

/** \brief Fill the last records of \a whole with those of \a local, moved. */
void
fillAppended(const pcl::PCLPointCloud2& local,
             const Eigen::Vector3d& offset,
             std::size_t first,
             pcl::PCLPointCloud2& whole)
{
  for (const pcl::PCLPointField& field : whole.fields) {
    const pcl::PCLPointField* const source = counterpart(field, local);
    if (source == nullptr)
      continue;
    const int axis = shiftedAxis(field);
    for (std::size_t i = first; i < ccaa::pointCount(local); ++i) {
      const std::uint8_t* const from = recordAt(local, i);
      std::uint8_t* const to = whole.data.data() + i * whole.point_step;
      if (axis < 0)
        std::memcpy(to + field.offset, from + source->offset, ccaa::fieldBytes(field));
      else
        writeReal(field, readReal(*source, from) + offset[axis], to);
    }
  }
}

bool
isReadable(const pcl::PCLPointCloud2& cloud, const char* method)
{
  const CloudProblem problem = ccaa::checkCloud(cloud);
  if (problem != CloudProblem::NONE)
    PCL_ERROR("[pcl::GlobalShift::%s] cannot read the cloud: %s (%zu points)\n",
              method,
              ccaa::describe(problem),
              ccaa::pointCount(cloud));
  return problem == CloudProblem::NONE;
}

} // namespace

GlobalShift
GlobalShift::of(const pcl::PCLPointCloud2& cloud)
{
  if (ccaa::checkCloud(cloud) != CloudProblem::NONE)
    return {};
  const ccaa::CloudExtent extent = ccaa::measureExtent(ccaa::positionView(cloud));
  if (!(extent.side > 0.0) ||
      !(extent.floatRounding() > FLOAT_ROUNDING_SHARE * extent.spacing))
    return {};
  const double unit = roundUnit(extent.side);
  const Eigen::Vector3d offset =
      (extent.box.center() / unit).array().round().matrix() * unit;
  return offset.allFinite() ? GlobalShift(offset) : GlobalShift();
}

bool
GlobalShift::toLocal(const pcl::PCLPointCloud2& cloud, pcl::PCLPointCloud2& local) const
{
  const bool can = isReadable(cloud, "toLocal");
  local = can ? movedCloud(cloud, pcl::PCLPointField::FLOAT32, -offset_)
              : pcl::PCLPointCloud2();
  return can;
}

bool
GlobalShift::toGlobal(const pcl::PCLPointCloud2& local,
                      pcl::PCLPointCloud2& cloud) const
{
  const bool can = isReadable(local, "toGlobal");
  cloud = can ? movedCloud(local, pcl::PCLPointField::FLOAT64, offset_)
              : pcl::PCLPointCloud2();
  return can;
}

bool
GlobalShift::restore(const pcl::PCLPointCloud2& cloud, pcl::PolygonMesh& mesh) const
{
  if (!isReadable(cloud, "restore") || !isReadable(mesh.cloud, "restore"))
    return false;
  const std::size_t points = ccaa::pointCount(cloud);
  const std::size_t all = ccaa::pointCount(mesh.cloud);
  if (all < points) {
    PCL_ERROR("[pcl::GlobalShift::restore] the mesh has fewer points (%zu) than the "
              "cloud (%zu)\n",
              all,
              points);
    return false;
  }
  pcl::PCLPointCloud2 whole = cloud;
  const std::vector<ccaa::NewVertex> appended(all - points);
  const CloudProblem problem = ccaa::appendVertices(whole, appended);
  if (problem != CloudProblem::NONE) {
    PCL_ERROR("[pcl::GlobalShift::restore] cannot append points: %s (%zu)\n",
              ccaa::describe(problem),
              appended.size());
    return false;
  }
  if (!appended.empty())
    fillAppended(mesh.cloud, offset_, points, whole);
  mesh.cloud = std::move(whole);
  return true;
}

} // namespace pcl
