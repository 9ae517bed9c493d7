// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a surface, and how the rest connects them.
#include "mesh/part_graph.h"

#include "mesh/sort_unique.h"

#include <algorithm>

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
                     const std::vector<std::uint8_t>& is_flagged,
                     int threads)
: triangles_(triangles)
, adjacency_(adjacency)
, is_flagged_(is_flagged)
, threads_(threads)
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
  const LoopContext context{threads_};
  std::vector<std::vector<pcl::index_t>> found(context.blockCount(triangles_.size()));
  forEachBlock(triangles_.size(),
               context,
               [&](std::size_t block, std::size_t begin, std::size_t end) {
                 for (std::size_t t = begin; t < end; ++t)
                   if (isPart(triangles_[t]))
                     found[block].push_back(static_cast<pcl::index_t>(t));
               });
  return joinBlocks(found);
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

/** All corners of a triangle that is in no part. */
void
PartGraph::joinRest(std::size_t t)
{
  const Triangle& triangle = triangles_[t];
  if (isPart(triangle))
    return;
  for (const std::size_t corner : {1U, 2U})
    outside_->join(static_cast<std::size_t>(triangle[0]),
                   static_cast<std::size_t>(triangle[corner]));
}

void
PartGraph::addBorders(std::size_t t, std::vector<Border>& borders) const
{
  const Triangle& triangle = triangles_[t];
  for (std::size_t corner = 0; corner < 3; ++corner)
    if (adjacency_.across(static_cast<pcl::index_t>(t), static_cast<int>(corner)) < 0)
      borders.push_back({static_cast<std::size_t>(triangle[corner]),
                         static_cast<std::size_t>(triangle[(corner + 1) % 3])});
}

void
PartGraph::connectRest(std::size_t connecting)
{
  outside_.emplace(is_flagged_.size());
  const LoopContext context{threads_};
  std::vector<std::vector<Border>> found(context.blockCount(triangles_.size()));
  forEachBlock(triangles_.size(),
               context,
               [&](std::size_t block, std::size_t begin, std::size_t end) {
                 for (std::size_t t = begin; t < end; ++t) {
                   joinRest(t);
                   addBorders(t, found[block]);
                 }
               });
  const std::vector<Border> borders = joinBlocks(found);
  DisjointSets openings(is_flagged_.size());
  for (const auto& [from, to] : borders)
    openings.join(from, to);
  std::map<std::size_t, std::size_t> edges;
  for (const Border& border : borders)
    ++edges[openings.find(border[0])];
  for (const auto& [from, to] : borders)
    if (edges[openings.find(from)] >= connecting)
      outside_->join(from, to);
}

} // namespace pcl::ccaa
