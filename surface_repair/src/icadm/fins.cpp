// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small islands that hang on a surface that is whole.

#include "icadm/fins.h"

#include <pcl/surface_repair/repair_parameters.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace pcl::repair {

namespace {

/** UNAVAILABLE comes first: an end has none. */
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

/** Call with the island and the points of each boundary edge of small islands. */
template <typename Call>
void
forEdgesOfSmallIslands(const IncompleteModel& model, const Call& call)
{
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const std::size_t island = model.island_of[t];
    for (int corner = 0; isSmall(model.islands[island]) && corner < 3; ++corner)
      if (model.adjacency.across(static_cast<pcl::index_t>(t), corner) < 0)
        call(island,
             pointEdge(model, model.triangles[t], static_cast<std::size_t>(corner)));
  }
}

} // namespace

std::set<PointEdge>
edgesWithFins(const IncompleteModel& model)
{
  std::map<PointEdge, std::vector<std::size_t>> islands_at;
  std::vector<bool> has_edge; // of each point
  forEdgesOfSmallIslands(model, [&](std::size_t island, const PointEdge& edge) {
    if (edge.first == pcl::UNAVAILABLE)
      return;
    islands_at[edge].push_back(island);
    has_edge.resize(
        std::max(has_edge.size(), static_cast<std::size_t>(edge.second) + 1), false);
    has_edge[static_cast<std::size_t>(edge.first)] = true;
    has_edge[static_cast<std::size_t>(edge.second)] = true;
  });
  const auto mayBeOf = [&](pcl::index_t point) {
    return point >= 0 && static_cast<std::size_t>(point) < has_edge.size() &&
           has_edge[static_cast<std::size_t>(point)];
  };
  std::set<PointEdge> edges;
  for (std::size_t t = 0; t < model.triangles.size() && !islands_at.empty(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const PointEdge edge = pointEdge(model, model.triangles[t], corner);
      if (!mayBeOf(edge.first) || !mayBeOf(edge.second) ||
          model.adjacency.across(static_cast<pcl::index_t>(t),
                                 static_cast<int>(corner)) < 0)
        continue;
      const auto found = islands_at.find(edge);
      if (found != islands_at.end() &&
          std::any_of(found->second.begin(), found->second.end(), [&](std::size_t i) {
            return i != model.island_of[t];
          }))
        edges.insert(edge);
    }
  return edges;
}

void
markFins(const std::set<PointEdge>& edges, IncompleteModel& model)
{
  if (!edges.empty())
    forEdgesOfSmallIslands(model, [&](std::size_t island, const PointEdge& edge) {
      if (edges.count(edge) > 0)
        model.islands[island].is_fin = true;
    });
}

} // namespace pcl::repair
