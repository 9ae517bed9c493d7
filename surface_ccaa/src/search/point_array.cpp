// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: indices that are none of an array's points.
#include <pcl/surface_ccaa/impl/point_array.h>

#include <algorithm>

namespace pcl::ccaa {

Indices::const_iterator
findIndexOutside(const Indices& indices, std::size_t point_count)
{
  return std::find_if(indices.begin(), indices.end(), [point_count](index_t index) {
    return index < 0 || static_cast<std::size_t>(index) >= point_count;
  });
}

std::string
indexFault(const Indices& indices, std::size_t point_count)
{
  const auto outside = findIndexOutside(indices, point_count);
  if (outside == indices.end())
    return {};
  return "index " + std::to_string(*outside) + " is outside the cloud of " +
         std::to_string(point_count) + " points";
}

} // namespace pcl::ccaa
