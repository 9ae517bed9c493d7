// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fields of raw clouds by name and type.
#pragma once

#include <pcl/common/io.h>
#include <pcl/PCLPointCloud2.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace pcl::ccaa {

/** \brief The first field of a name, or nullptr. */
inline const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const auto found =
      std::find_if(cloud.fields.begin(), cloud.fields.end(), [&](const auto& field) {
        return field.name == name;
      });
  return found == cloud.fields.end() ? nullptr : &*found;
}

inline bool
isFloating(const pcl::PCLPointField& field)
{
  return field.datatype == pcl::PCLPointField::FLOAT32 ||
         field.datatype == pcl::PCLPointField::FLOAT64;
}

/** \brief Number of values; writers of old files leave the count at 0 for one. */
inline std::size_t
valueCount(const pcl::PCLPointField& field)
{
  return std::max<std::size_t>(1, field.count);
}

/** \brief Bytes a field takes; none for a type PCL does not know. */
inline std::size_t
fieldBytes(const pcl::PCLPointField& field)
{
  return static_cast<std::size_t>(pcl::getFieldSize(field.datatype)) *
         valueCount(field);
}

} // namespace pcl::ccaa
