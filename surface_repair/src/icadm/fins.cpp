// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small islands that hang on a surface that is whole.

#include "icadm/fins.h"

#include <pcl/surface_repair/repair_parameters.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace pcl {
namespace repair {

namespace {

/** Points of the cloud, the lower one first; UNAVAILABLE first: an end has none. */
using PointEdge = std::pair<pcl::index_t, pcl::index_t>;

PointEdge
pointEdge(const IncompleteModel& model, const Triangle& triangle, std::size_t corner)
{
  const auto point = [&](std::size_t k) {
    return model.point_of_vertex[static_cast<std::size_t>(triangle[k % 3])];
  };
  return std::minmax(point(corner), point(corner + 1));
}

bool
isSmall(const Island& island)
{
  return island.triangles < CRUMB_TRIANGLES && !island.closed;
}

/** Boundary edges of small islands, and these. */
std::map<PointEdge, std::vector<std::size_t>>
edgesOfSmallIslands(const IncompleteModel& model)
{
  std::map<PointEdge, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const std::size_t island = model.island_of[t];
    for (int corner = 0; isSmall(model.islands[island]) && corner < 3; ++corner)
      if (model.adjacency.across(static_cast<pcl::index_t>(t), corner) < 0) {
        const PointEdge edge =
            pointEdge(model, model.triangles[t], static_cast<std::size_t>(corner));
        if (edge.first != pcl::UNAVAILABLE)
          edges[edge].push_back(island);
      }
  }
  return edges;
}

} // namespace

void
markFins(IncompleteModel& model)
{
  const auto edges = edgesOfSmallIslands(model);
  if (edges.empty())
    return;
  std::vector<bool> has_edge;
  for (const auto& [edge, islands] : edges) {
    has_edge.resize(
        std::max(has_edge.size(), static_cast<std::size_t>(edge.second) + 1), false);
    has_edge[static_cast<std::size_t>(edge.first)] = true;
    has_edge[static_cast<std::size_t>(edge.second)] = true;
  }
  const auto mayBeOf = [&](pcl::index_t point) {
    return point >= 0 && static_cast<std::size_t>(point) < has_edge.size() &&
           has_edge[static_cast<std::size_t>(point)];
  };
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const PointEdge edge = pointEdge(model, model.triangles[t], corner);
      if (!mayBeOf(edge.first) || !mayBeOf(edge.second) ||
          model.adjacency.across(static_cast<pcl::index_t>(t),
                                 static_cast<int>(corner)) < 0)
        continue;
      const auto found = edges.find(edge);
      if (found == edges.end())
        continue;
      for (const std::size_t island : found->second)
        if (island != model.island_of[t])
          model.islands[island].is_fin = true;
    }
}

} // namespace repair
} // namespace pcl
