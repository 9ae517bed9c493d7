// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: regions large enough to be trusted (condition C3.4-3).
#include "umbrella/region_growth.h"

#include "mesh/disjoint_sets.h"

#include <atomic>
#include <cstdint>
#include <numeric>

namespace pcl::ccaa {
namespace {

bool
joinCorners(const Triangles& triangles,
            const AliveFlags& alive,
            std::size_t vertex_count,
            const LoopContext& context,
            DisjointSets& regions)
{
  const auto make = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      regions.makeSet(i);
  };
  const auto join = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (alive[i] == 0)
        continue;
      const Triangle& triangle = triangles[i];
      regions.join(std::size_t(triangle[0]), std::size_t(triangle[1]));
      regions.join(std::size_t(triangle[0]), std::size_t(triangle[2]));
    }
  };
  return forEachBlock(vertex_count, context, make) &&
         forEachBlock(triangles.size(), context, join);
}

/** \brief Of each root the number of internal points of its region. Neighbours mostly
 * lie in one region: runs are added at once, which keeps threads off each other. */
std::vector<std::atomic<std::uint32_t>>
countInternalPoints(const std::vector<Fan>& fans,
                    const LoopContext& context,
                    DisjointSets& regions)
{
  std::vector<std::atomic<std::uint32_t>> internal(fans.size());
  const auto count = [&](std::size_t, std::size_t begin, std::size_t end) {
    std::size_t root = 0;
    std::uint32_t run = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (fans[i] != Fan::CLOSED)
        continue;
      const std::size_t next = regions.find(i);
      if (next != root) {
        internal[root].fetch_add(run, std::memory_order_relaxed);
        root = next;
        run = 0;
      }
      ++run;
    }
    if (run != 0)
      internal[root].fetch_add(run, std::memory_order_relaxed);
  };
  forEachBlock(fans.size(), context, count);
  return internal;
}

std::size_t
sum(const std::vector<std::size_t>& parts)
{
  return std::accumulate(parts.begin(), parts.end(), std::size_t{0});
}

} // namespace

RegionReport
removeSmallRegions(const Triangles& triangles,
                   std::size_t minimum_internal_points,
                   const LoopContext& context,
                   AliveFlags& alive,
                   std::vector<Fan>& fans)
{
  RegionReport report;
  DisjointSets regions(fans.size(), DisjointSets::Begin::EMPTY);
  if (!joinCorners(triangles, alive, fans.size(), context, regions))
    return report;
  const auto internal = countInternalPoints(fans, context, regions);
  const auto is_small = [&](std::size_t vertex) {
    return internal[regions.find(vertex)].load(std::memory_order_relaxed) <
           minimum_internal_points;
  };
  std::vector<std::size_t> kept(context.blockCount(fans.size()));
  const auto free_points = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (fans[i] == Fan::NONE)
        continue;
      if (is_small(i))
        fans[i] = Fan::NONE;
      else
        kept[block] += regions.isRoot(i) ? 1 : 0;
    }
  };
  std::vector<std::size_t> removed(context.blockCount(triangles.size()));
  const auto remove = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (alive[i] != 0 &&
          fans[static_cast<std::size_t>(triangles[i][0])] == Fan::NONE) {
        alive[i] = 0;
        ++removed[block];
      }
  };
  if (!forEachBlock(fans.size(), context, free_points) ||
      !forEachBlock(triangles.size(), context, remove))
    return report;
  report.regions_kept = sum(kept);
  report.triangles_removed = sum(removed);
  return report;
}

} // namespace pcl::ccaa
