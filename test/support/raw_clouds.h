// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: raw clouds of any layout for tests.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Name and PCLPointField type of a field. */
using FieldList = std::vector<std::pair<std::string, std::uint8_t>>;

inline FieldList
xyzFields()
{
  return {{"x", pcl::PCLPointField::FLOAT32},
          {"y", pcl::PCLPointField::FLOAT32},
          {"z", pcl::PCLPointField::FLOAT32}};
}

/** \brief Unorganised cloud of zeros with the fields one after the other, unaligned. */
pcl::PCLPointCloud2
rawCloud(const FieldList& fields, std::size_t points);

/** \brief The field of a name; it must exist. */
const pcl::PCLPointField&
fieldOf(const pcl::PCLPointCloud2& cloud, const std::string& name);

template <typename Number>
void
setValue(pcl::PCLPointCloud2& cloud,
         std::size_t point,
         const std::string& name,
         Number value)
{
  const std::size_t offset = point * cloud.point_step + fieldOf(cloud, name).offset;
  std::memcpy(cloud.data.data() + offset, &value, sizeof(value));
}

template <typename Number>
Number
valueOf(const pcl::PCLPointCloud2& cloud, std::size_t point, const std::string& name)
{
  Number value;
  const std::size_t offset = point * cloud.point_step + fieldOf(cloud, name).offset;
  std::memcpy(&value, cloud.data.data() + offset, sizeof(value));
  return value;
}

/** \brief Write three floats at a byte offset. */
void
setPosition(pcl::PCLPointCloud2& cloud, std::size_t offset, const Position& position);

/** \brief Make an unorganised cloud of width * height points an organised one with so
 * many bytes after each row, all 0xee. */
void
padRows(pcl::PCLPointCloud2& cloud,
        std::uint32_t width,
        std::uint32_t height,
        std::size_t padding);

} // namespace pcl::ccaa::test
