// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: through which parts of a surface its handles pass.
#include "mesh/handle_places.h"

#include "mesh/part_graph.h"

#include <algorithm>

namespace pcl::ccaa {

std::vector<HandlePlace>
handlePlaces(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const std::vector<std::uint8_t>& is_flagged,
             int threads)
{
  using Part = PartGraph::Part;
  PartGraph graph(triangles, adjacency, is_flagged, threads);
  std::vector<const Part*> order; // discs have no handle and are on no cycle
  for (const auto& [node, part] : graph.parts())
    if (part.loops.size() > 1 || part.genus() > 0)
      order.push_back(&part);
  if (order.empty())
    return {};
  std::stable_sort(order.begin(), order.end(), [](const Part* a, const Part* b) {
    return a->triangles > b->triangles;
  });
  graph.connectRest(0);
  DisjointSets nodes(graph.nodeCount());
  std::vector<HandlePlace> places;
  for (const Part* part : order) {
    bool has_handle = part->genus() > 0;
    for (const std::size_t loop : part->loops) {
      const std::size_t rest = graph.nodeBehind(loop);
      has_handle = has_handle || nodes.find(part->root) == nodes.find(rest);
      nodes.join(part->root, rest);
    }
    if (has_handle)
      places.push_back({part->flagged, part->vertices});
  }
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.flagged < b.flagged;
  });
  return places;
}

} // namespace pcl::ccaa
