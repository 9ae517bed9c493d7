// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: adds normals or a sensor position to a cloud with any
// fields.
#include "cloud_normals.h"

#include "point_columns.h"

#include <array>
#include <cstring>
#include <utility>

namespace app {
namespace {

using Names = std::array<const char*, 3>;

constexpr Names NORMAL_FIELDS{"normal_x", "normal_y", "normal_z"};
constexpr Names VIEWPOINT_FIELDS{"vp_x", "vp_y", "vp_z"};

template <typename Real>
void
appendFields(const Names& names, pcl::PCLPointCloud2& cloud)
{
  for (const char* name : names) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = sizeof(Real) == sizeof(double) ? pcl::PCLPointField::FLOAT64
                                                    : pcl::PCLPointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += sizeof(Real);
  }
  cloud.row_step = cloud.point_step * cloud.width;
}

/** Append three numbers to every point, those of point i at \a triple_of(i). */
template <typename Real, typename TripleOf>
bool
appendTriples(const Names& names, const TripleOf& triple_of, pcl::PCLPointCloud2& cloud)
{
  for (const char* name : names)
    if (findField(cloud, name) != nullptr)
      return false;
  constexpr std::size_t TRIPLE_BYTES = 3 * sizeof(Real);
  const std::size_t step = cloud.point_step;
  const std::size_t points = pointCount(cloud);
  std::vector<std::uint8_t> data(points * (step + TRIPLE_BYTES));
  std::uint8_t* target = data.data();
  for (std::size_t i = 0; i < points; ++i) {
    std::memcpy(target, pointAt(cloud, i), step);
    std::memcpy(target + step, triple_of(i), TRIPLE_BYTES);
    target += step + TRIPLE_BYTES;
  }
  cloud.data = std::move(data);
  appendFields<Real>(names, cloud);
  return true;
}

} // namespace

bool
appendNormals(const pcl::PointCloud<pcl::Normal>& normals, pcl::PCLPointCloud2& cloud)
{
  return appendTriples<float>(
      NORMAL_FIELDS, [&](std::size_t i) { return normals[i].data_n; }, cloud);
}

bool
needsDouble(const Viewpoint& viewpoint)
{
  return viewpoint.position.cast<float>().cast<double>() != viewpoint.position;
}

bool
appendViewpoint(const Viewpoint& viewpoint, pcl::PCLPointCloud2& cloud, bool as_double)
{
  if (!viewpoint.known)
    return false;
  const Eigen::Vector3f single = viewpoint.position.cast<float>();
  if (!as_double && !needsDouble(viewpoint))
    return appendTriples<float>(
        VIEWPOINT_FIELDS, [&](std::size_t) { return single.data(); }, cloud);
  return appendTriples<double>(
      VIEWPOINT_FIELDS, [&](std::size_t) { return viewpoint.position.data(); }, cloud);
}

} // namespace app
