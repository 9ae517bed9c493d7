// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bringing any mesh to condition C3.4-1.
#include "umbrella/edge_repair.h"

#include "umbrella/wing_pairs.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::ccaa {
namespace {

using Edge = TriangleAdjacency::Edge;

/** Few enough that also a short list of edges keeps several threads busy. */
constexpr std::size_t EDGE_BLOCK = 256;

bool
isSuspect(Fan fan)
{
  return fan == Fan::OVERFULL || fan == Fan::SEVERAL;
}

/** \brief Triangles at a vertex that are there already, among those whose lowest
 * corner it is. \param sorted scratch */
void
findDuplicates(const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               pcl::index_t vertex,
               std::vector<std::pair<Triangle, pcl::index_t>>& sorted,
               std::vector<pcl::index_t>& duplicates)
{
  sorted.clear();
  for (const auto* item = adjacency.begin(vertex); item != adjacency.end(vertex);
       ++item) {
    Triangle corners = triangles[static_cast<std::size_t>(*item)];
    std::sort(corners.begin(), corners.end());
    if (corners[0] == vertex)
      sorted.emplace_back(corners, *item);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      duplicates.push_back(sorted[i].second);
}

std::size_t
removeDuplicates(const Triangles& triangles,
                 const TriangleAdjacency& adjacency,
                 const LoopContext& context,
                 AliveFlags& alive)
{
  const std::size_t count = adjacency.vertexCount();
  std::vector<std::vector<pcl::index_t>> parts(context.blockCount(count));
  const auto find = [&](std::size_t block, std::size_t begin, std::size_t end) {
    std::vector<std::pair<Triangle, pcl::index_t>> sorted;
    for (auto i = static_cast<pcl::index_t>(begin); i < static_cast<pcl::index_t>(end);
         ++i)
      if (isSuspect(adjacency.fan(i)))
        findDuplicates(triangles, adjacency, i, sorted, parts[block]);
  };
  forEachBlock(count, context, find);
  const auto duplicates = joinBlocks(parts);
  for (const auto triangle : duplicates)
    alive[static_cast<std::size_t>(triangle)] = 0;
  return duplicates.size();
}

std::vector<pcl::index_t>
liveTrianglesOn(std::size_t overfull_edge,
                const TriangleAdjacency& adjacency,
                const AliveFlags& alive)
{
  std::vector<pcl::index_t> live;
  std::copy_if(adjacency.beginOverfull(overfull_edge),
               adjacency.endOverfull(overfull_edge),
               std::back_inserter(live),
               [&](pcl::index_t triangle) {
                 return alive[static_cast<std::size_t>(triangle)] != 0;
               });
  return live;
}

/** \brief Whether exactly two live triangles are on the edge of a live one. */
bool
hasTwo(pcl::index_t triangle,
       int corner,
       const Edge& edge,
       const TriangleAdjacency& adjacency,
       const AliveFlags& alive)
{
  const auto across = adjacency.across(triangle, corner);
  if (across >= 0)
    return alive[static_cast<std::size_t>(across)] != 0;
  if (across == TriangleAdjacency::NONE)
    return false;
  const auto& edges = adjacency.overfullEdges();
  const auto place = std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin();
  return liveTrianglesOn(static_cast<std::size_t>(place), adjacency, alive).size() == 2;
}

/** \brief How many of a triangle's edges other than the given one have two triangles.
 */
int
supportOf(pcl::index_t triangle,
          const Edge& edge,
          const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const AliveFlags& alive)
{
  const Triangle& corners = triangles[static_cast<std::size_t>(triangle)];
  int support = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Edge other{corners[corner], corners[(corner + 1) % 3]};
    std::sort(other.begin(), other.end());
    if (other != edge &&
        hasTwo(triangle, static_cast<int>(corner), other, adjacency, alive))
      ++support;
  }
  return support;
}

/** \brief Of the triangles on an overfull edge leave those in `wings` that have to go.
 */
void
leaveLosers(const Edge& edge,
            const Triangles& triangles,
            const TriangleAdjacency& adjacency,
            const Positions& positions,
            const AliveFlags& alive,
            std::vector<pcl::index_t>& wings)
{
  if (wings.size() > MAXIMUM_WINGS)
    return;
  std::vector<Wing> described;
  for (const auto triangle : wings)
    described.push_back(
        describeWing(edge,
                     triangles[static_cast<std::size_t>(triangle)],
                     supportOf(triangle, edge, triangles, adjacency, alive),
                     positions));
  const auto pair = bestWingPair(described);
  if (!pair)
    return;
  wings.erase(wings.begin() + static_cast<std::ptrdiff_t>(pair->second));
  wings.erase(wings.begin() + static_cast<std::ptrdiff_t>(pair->first));
}

} // namespace

EdgeRepairReport
repairNonManifoldEdges(const Triangles& triangles,
                       const TriangleAdjacency& adjacency,
                       const Positions& positions,
                       const LoopContext& context,
                       AliveFlags& alive)
{
  EdgeRepairReport report;
  report.duplicate_triangles = removeDuplicates(triangles, adjacency, context, alive);
  const auto& edges = adjacency.overfullEdges();
  LoopContext by_edge = context;
  by_edge.block_size = EDGE_BLOCK;
  std::vector<std::vector<pcl::index_t>> rejected(by_edge.blockCount(edges.size()));
  std::vector<std::size_t> overfull(rejected.size());
  const auto judge = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      auto wings = liveTrianglesOn(i, adjacency, alive);
      if (wings.size() < 3)
        continue;
      ++overfull[block];
      leaveLosers(edges[i], triangles, adjacency, positions, alive, wings);
      rejected[block].insert(rejected[block].end(), wings.begin(), wings.end());
    }
  };
  forEachBlock(edges.size(), by_edge, judge);
  for (const auto count : overfull)
    report.overfull_edges += count;
  for (const auto triangle : joinBlocks(rejected)) {
    report.overfull_triangles += alive[static_cast<std::size_t>(triangle)];
    alive[static_cast<std::size_t>(triangle)] = 0;
  }
  return report;
}

} // namespace pcl::ccaa
