// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: raw clouds of any layout for tests.
#include "raw_clouds.h"

#include <pcl/common/io.h>

#include <algorithm>

namespace pcl::ccaa::test {

pcl::PCLPointCloud2
rawCloud(const FieldList& fields, std::size_t points)
{
  pcl::PCLPointCloud2 cloud;
  for (const auto& entry : fields) {
    pcl::PCLPointField field;
    field.name = entry.first;
    field.datatype = entry.second;
    field.count = 1;
    field.offset = cloud.point_step;
    cloud.point_step += static_cast<uindex_t>(pcl::getFieldSize(entry.second));
    cloud.fields.push_back(field);
  }
  cloud.width = static_cast<uindex_t>(points);
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 1;
  cloud.data.assign(cloud.row_step, 0);
  return cloud;
}

const pcl::PCLPointField&
fieldOf(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  return *std::find_if(cloud.fields.begin(),
                       cloud.fields.end(),
                       [&](const auto& field) { return field.name == name; });
}

void
setPosition(pcl::PCLPointCloud2& cloud, std::size_t offset, const Position& position)
{
  const Eigen::Vector3f values = position.cast<float>();
  std::memcpy(cloud.data.data() + offset, values.data(), 3 * sizeof(float));
}

void
padRows(pcl::PCLPointCloud2& cloud,
        std::uint32_t width,
        std::uint32_t height,
        std::size_t padding)
{
  const std::size_t row_bytes = static_cast<std::size_t>(width) * cloud.point_step;
  std::vector<std::uint8_t> padded(height * (row_bytes + padding), 0xee);
  for (std::size_t row = 0; row < height; ++row)
    std::memcpy(padded.data() + row * (row_bytes + padding),
                cloud.data.data() + row * row_bytes,
                row_bytes);
  cloud.data = std::move(padded);
  cloud.width = width;
  cloud.height = height;
  cloud.row_step = static_cast<uindex_t>(row_bytes + padding);
}

} // namespace pcl::ccaa::test
