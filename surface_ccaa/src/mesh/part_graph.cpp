// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a surface, and how the rest connects them.
#include "mesh/part_graph.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <array>

namespace pcl::ccaa {

/** Of 2 - 2 g = V - E + F + loops. A vertex at which several fans of the part meet
 * counts for each: as often as cut edges lead from it. */
long
PartGraph::Part::genus() const
{
  const std::size_t corners = vertices.size() - cut_vertices.size() + cut_edges.size();
  const std::size_t edges = (3 * triangles + cut_edges.size()) / 2;
  return 1 - (static_cast<long>(corners + triangles + loops.size()) -
              static_cast<long>(edges)) /
                 2;
}

PartGraph::PartGraph(const Triangles& triangles,
                     const TriangleAdjacency& adjacency,
                     const std::vector<std::uint8_t>& is_flagged)
: triangles_(triangles)
, adjacency_(adjacency)
, is_flagged_(is_flagged)
, list_(listTriangles())
, inside_(list_.size())
, loops_(3 * list_.size())
{
  for (std::size_t edge = 0; edge < 3 * list_.size(); ++edge)
    if (isCut(edge))
      loops_.join(edge, nextCut(edge));
    else
      inside_.join(edge / 3, placeAcross(edge));
  gatherParts();
}

std::vector<pcl::index_t>
PartGraph::listTriangles() const
{
  std::vector<pcl::index_t> list;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (isPart(triangles_[t]))
      list.push_back(static_cast<pcl::index_t>(t));
  return list;
}

/** Whether it is one between a part and the rest, or the surface ends there. */
bool
PartGraph::isCut(std::size_t edge) const
{
  const pcl::index_t t = across(edge);
  return t < 0 || !isPart(triangles_[static_cast<std::size_t>(t)]);
}

/** In the list, of the triangle across an edge that is not cut. */
std::size_t
PartGraph::placeAcross(std::size_t edge) const
{
  return static_cast<std::size_t>(
      std::lower_bound(list_.begin(), list_.end(), across(edge)) - list_.begin());
}

/** The cut edge that follows around the same part. */
std::size_t
PartGraph::nextCut(std::size_t edge) const
{
  for (edge = after(edge); !isCut(edge);) {
    const pcl::index_t vertex = startOf(edge);
    edge = 3 * placeAcross(edge);
    edge += static_cast<std::size_t>(cornerOf(triangleOf(edge), vertex));
  }
  return edge;
}

void
PartGraph::gatherParts()
{
  for (std::size_t edge = 0; edge < 3 * list_.size(); ++edge) {
    Part& part = parts_[inside_.find(edge / 3)];
    part.triangles += edge % 3 == 0 ? 1 : 0;
    part.vertices.push_back(startOf(edge));
    if (!isCut(edge))
      continue;
    part.cut_edges.push_back(edge);
    part.cut_vertices.push_back(startOf(edge));
    part.loops.push_back(loops_.find(edge));
  }
  for (auto& [root, part] : parts_) {
    part.root = root;
    sortUnique(part.vertices);
    sortUnique(part.cut_vertices);
    sortUnique(part.loops);
    part.flagged = *std::find_if(part.vertices.begin(),
                                 part.vertices.end(),
                                 [&](pcl::index_t v) { return isFlagged(v); });
  }
}

void
PartGraph::connectRest(std::size_t connecting)
{
  outside_.emplace(is_flagged_.size());
  DisjointSets openings(is_flagged_.size());
  std::vector<std::array<std::size_t, 2>> borders;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto from = static_cast<std::size_t>(triangles_[t][corner]);
      const auto to = static_cast<std::size_t>(triangles_[t][(corner + 1) % 3]);
      if (!isPart(triangles_[t]))
        outside_->join(from, to);
      if (adjacency_.across(static_cast<pcl::index_t>(t), int(corner)) < 0) {
        openings.join(from, to);
        borders.push_back({from, to});
      }
    }
  std::map<std::size_t, std::size_t> edges;
  for (const auto& border : borders)
    ++edges[openings.find(border[0])];
  for (const auto& [from, to] : borders)
    if (edges[openings.find(from)] >= connecting)
      outside_->join(from, to);
}

} // namespace pcl::ccaa
