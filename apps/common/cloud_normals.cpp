// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: adds normals to a cloud with any fields.
#include "cloud_normals.h"

#include "point_columns.h"

#include <cstring>
#include <utility>

namespace app {
namespace {

constexpr const char* NORMAL_FIELDS[] = {"normal_x", "normal_y", "normal_z"};
constexpr std::size_t NORMAL_BYTES = 3 * sizeof(float);

void
appendFields(pcl::PCLPointCloud2& cloud)
{
  for (const char* name : NORMAL_FIELDS) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = pcl::PCLPointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += sizeof(float);
  }
  cloud.row_step = cloud.point_step * cloud.width;
}

} // namespace

bool
appendNormals(const pcl::PointCloud<pcl::Normal>& normals, pcl::PCLPointCloud2& cloud)
{
  for (const char* name : NORMAL_FIELDS)
    if (findField(cloud, name) != nullptr)
      return false;
  const std::size_t step = cloud.point_step;
  std::vector<std::uint8_t> data(normals.size() * (step + NORMAL_BYTES));
  std::uint8_t* target = data.data();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    std::memcpy(target, pointAt(cloud, i), step);
    std::memcpy(target + step, normals[i].data_n, NORMAL_BYTES);
    target += step + NORMAL_BYTES;
  }
  cloud.data = std::move(data);
  appendFields(cloud);
  return true;
}

} // namespace app
