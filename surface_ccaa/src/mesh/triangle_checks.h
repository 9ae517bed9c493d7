// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether the indices of a triangle make sense.
#pragma once

#include "mesh/triangle.h"

#include <cstddef>

namespace pcl::ccaa {

/** \brief Three different corners, all below vertex_count. */
inline bool
hasValidIndices(const Triangle& triangle, std::size_t vertex_count)
{
  for (const pcl::index_t vertex : triangle)
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count)
      return false;
  return triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
         triangle[2] != triangle[0];
}

} // namespace pcl::ccaa
