// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all pairs of triangles of a mesh that meet.
#include "mesh/block_loop.h"
#include "mesh/box_tree.h"
#include "mesh/corners.h"
#include "mesh/intersection.h"
#include "mesh/triangle_checks.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Operations of a search in the tree, of a test of two triangles, and so many that are
 * told together. */
constexpr std::uint64_t SEARCH_WORK = 50;
constexpr std::uint64_t TEST_WORK = 5;
constexpr std::uint64_t MOST_UNTOLD = 10000;

bool
isTestable(const Triangle& triangle, const PointView& positions)
{
  if (!hasValidIndices(triangle, positions.size()))
    return false;
  const Corners corners = cornersOf(triangle, positions);
  return corners[0].allFinite() && corners[1].allFinite() && corners[2].allFinite() &&
         !isCollinear(corners);
}

/** \brief A box for each triangle, empty where it is not to be tested. */
std::vector<Box>
boxesOf(const Triangles& triangles,
        const PointView& positions,
        const LoopContext& context)
{
  std::vector<Box> boxes(triangles.size());
  forEachBlock(
      triangles.size(), context, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (isTestable(triangles[i], positions))
            for (const pcl::index_t vertex : triangles[i])
              boxes[i].extend(positions[vertex]);
      });
  return boxes;
}

} // namespace

SelfIntersections
findSelfIntersections(const Triangles& triangles,
                      const PointView& positions,
                      int threads,
                      RunControl& control)
{
  SelfIntersections result;
  const std::vector<Box> boxes = boxesOf(triangles, positions, {threads});
  control.spend(triangles.size());
  const BoxTree tree(boxes, threads, &control);
  control.spend(triangles.size());
  const std::size_t count = tree.order().size();
  result.left_out = triangles.size() - count;
  LoopContext context{threads, &control, "self-intersections"};
  context.block_size = 1024;
  std::vector<std::vector<TrianglePair>> found(context.blockCount(count));
  const auto searchBlock = [&](std::size_t block, std::size_t begin, std::size_t end) {
    std::uint64_t work = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (work > MOST_UNTOLD && !control.spend(std::exchange(work, 0)))
        return;
      work += SEARCH_WORK;
      const pcl::index_t own = tree.order()[i];
      const auto index = static_cast<std::size_t>(own);
      const Corners corners = cornersOf(triangles[index], positions);
      tree.forEachMeeting(corners, [&](pcl::index_t other) {
        if (other <= own)
          return;
        work += TEST_WORK;
        const Triangle& second = triangles[static_cast<std::size_t>(other)];
        if (trianglesMeet(corners, cornersOf(second, positions)))
          found[block].emplace_back(own, other);
      });
    }
    control.spend(work);
  };
  if (!control.report("self-intersections", 0.0) ||
      !forEachBlock(count, context, searchBlock)) {
    result.cancelled = true;
    return result;
  }
  result.pairs = joinBlocks(found);
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

} // namespace pcl::ccaa
