// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans that touch in one point, taken apart.

#include "point_fans.h"

#include <algorithm>

namespace pcl {
namespace repair {

namespace {

/** The triangles at a vertex that edges at the vertex connect to one of them. */
std::vector<pcl::index_t>
fanOf(pcl::index_t first,
      pcl::index_t vertex,
      const ccaa::Triangles& triangles,
      const ccaa::TriangleAdjacency& adjacency)
{
  std::vector<pcl::index_t> fan{first};
  for (std::size_t i = 0; i < fan.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const auto& corners = triangles[static_cast<std::size_t>(fan[i])];
      const auto at = static_cast<std::size_t>(corner);
      if (corners[at] != vertex && corners[(at + 1) % 3] != vertex)
        continue;
      const pcl::index_t next = adjacency.across(fan[i], corner);
      if (next >= 0 && std::find(fan.begin(), fan.end(), next) == fan.end())
        fan.push_back(next);
    }
  return fan;
}

} // namespace

PointFans
separateFans(const ccaa::Triangles& triangles, const ccaa::TriangleAdjacency& adjacency)
{
  PointFans result{triangles, {}};
  const auto vertices = static_cast<pcl::index_t>(adjacency.vertexCount());
  for (pcl::index_t vertex = 0; vertex < vertices; ++vertex) {
    if (adjacency.fan(vertex) != ccaa::Fan::SEVERAL)
      continue;
    std::vector<pcl::index_t> left(adjacency.begin(vertex), adjacency.end(vertex));
    for (bool is_first = true; !left.empty(); is_first = false) {
      const std::vector<pcl::index_t> fan =
          fanOf(left.front(), vertex, triangles, adjacency);
      left.erase(std::remove_if(left.begin(),
                                left.end(),
                                [&](pcl::index_t t) {
                                  return std::find(fan.begin(), fan.end(), t) !=
                                         fan.end();
                                }),
                 left.end());
      if (is_first)
        continue;
      const auto own = static_cast<pcl::index_t>(static_cast<std::size_t>(vertices) +
                                                 result.vertices.size());
      result.vertices.push_back(vertex);
      for (const pcl::index_t t : fan) {
        auto& corners = result.triangles[static_cast<std::size_t>(t)];
        std::replace(corners.begin(), corners.end(), vertex, own);
      }
    }
  }
  return result;
}

} // namespace repair
} // namespace pcl
