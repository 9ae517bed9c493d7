// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a connected region of new triangles.

#include "filling/patch.h"

#include "mesh/surface_topology.h"

namespace pcl::repair {

ccaa::SurfaceTopology
surfaceKindOf(const Patch& patch)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(patch.triangles, patch.positions.size());
  return ccaa::topologyOf(patch.triangles, adjacency);
}

Patch
keepTriangles(const Patch& patch, const std::vector<bool>& is_kept)
{
  Patch left;
  std::vector<pcl::index_t> number(patch.positions.size(), -1);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (!is_kept[t])
      continue;
    left.triangles.push_back(patch.triangles[t]);
    left.hole.push_back(patch.hole[t]);
    for (const pcl::index_t corner : patch.triangles[t])
      number[static_cast<std::size_t>(corner)] = 0;
  }
  for (std::size_t v = 0; v < patch.positions.size(); ++v) {
    if (number[v] == -1)
      continue;
    number[v] = static_cast<pcl::index_t>(left.positions.size());
    left.positions.push_back(patch.positions[v]);
    left.free_point.push_back(patch.free_point[v]);
    if (v < patch.rim.size())
      left.rim.push_back(patch.rim[v]);
  }
  for (const auto& [a, b] : patch.creases)
    if (number[a] != -1 && number[b] != -1)
      left.addCrease(static_cast<std::size_t>(number[a]),
                     static_cast<std::size_t>(number[b]));
  for (Triangle& triangle : left.triangles)
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
  return left;
}

} // namespace pcl::repair
