// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the triangles at each vertex, in flat arrays.

#pragma once

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief Which triangles meet at a vertex, in ascending order. */
class VertexTriangles {
public:
  VertexTriangles(const ccaa::Triangles& triangles, std::size_t vertices)
  : offsets_(vertices + 1, 0), triangles_(3 * triangles.size())
  {
    for (const ccaa::Triangle& triangle : triangles)
      for (const pcl::index_t corner : triangle)
        ++offsets_[static_cast<std::size_t>(corner) + 1];
    for (std::size_t v = 0; v < vertices; ++v)
      offsets_[v + 1] += offsets_[v];
    std::vector<std::uint32_t> place(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const pcl::index_t corner : triangles[t])
        triangles_[place[static_cast<std::size_t>(corner)]++] =
            static_cast<std::uint32_t>(t);
  }

  const std::uint32_t*
  begin(std::size_t vertex) const
  {
    return triangles_.data() + offsets_[vertex];
  }
  const std::uint32_t*
  end(std::size_t vertex) const
  {
    return triangles_.data() + offsets_[vertex + 1];
  }

private:
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> triangles_;
};

} // namespace pcl::repair
