// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: building the unoriented triangle adjacency.
#include "mesh/triangle_adjacency.h"

#include "mesh/block_loop.h"
#include "mesh/vertex_link.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Part of the triangles that may be appended: to sort the corners of more takes longer
 * than to count all. */
constexpr std::size_t APPENDED_SHARE = 8;

/** \brief Count the triangles of each vertex. */
bool
countTriangles(const Triangles& triangles,
               const LoopContext& context,
               std::vector<std::uint32_t>& counts)
{
  const auto count =
      [&](std::size_t first, std::size_t last, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (const auto corner : triangles[i]) {
            const auto vertex = static_cast<std::size_t>(corner);
            if (vertex >= first && vertex < last)
              ++counts[vertex];
          }
      };
  return forEachRange(counts.size(), triangles.size(), context, count);
}

/** \brief Write each triangle into the lists of its corners. ends[v] is one past the
 * list of v before, its begin afterwards. From the last triangle to the first, so that
 * the lists become ascending. */
bool
fillLists(const Triangles& triangles,
          const LoopContext& context,
          std::vector<std::uint32_t>& ends,
          pcl::index_t* lists)
{
  const std::size_t count = triangles.size();
  const auto fill =
      [&](std::size_t first, std::size_t last, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (const auto corner : triangles[count - 1 - i]) {
            const auto vertex = static_cast<std::size_t>(corner);
            if (vertex >= first && vertex < last)
              lists[--ends[vertex]] = static_cast<pcl::index_t>(count - 1 - i);
          }
      };
  return forEachRange(ends.size(), count, context, fill);
}

} // namespace

void
TriangleAdjacency::clear()
{
  *this = TriangleAdjacency();
}

void
TriangleAdjacency::build(const Triangles& triangles,
                         std::size_t vertex_count,
                         int threads,
                         RunControl* control)
{
  const LoopContext context{threads, control, "adjacency", BLOCK_SIZE};
  clear();
  if (!listTriangles(triangles, vertex_count, context) ||
      !matchEdges(triangles, context))
    clear();
}

bool
TriangleAdjacency::listTriangles(const Triangles& triangles,
                                 std::size_t vertex_count,
                                 const LoopContext& context)
{
  offsets_.assign(vertex_count + 1, 0);
  if (!countTriangles(triangles, context, offsets_))
    return false;
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  incident_.resize(3 * triangles.size());
  return fillLists(triangles, context, offsets_, incident_.data());
}

bool
TriangleAdjacency::matchEdges(const Triangles& triangles, const LoopContext& context)
{
  const std::size_t vertex_count = offsets_.size() - 1;
  across_.resize(3 * triangles.size());
  fans_.resize(vertex_count);
  std::vector<std::vector<EdgeTriangle>> overfull(context.blockCount(vertex_count));
  const auto match = [&](std::size_t block, std::size_t begin, std::size_t end) {
    VertexLink link;
    for (std::size_t v = begin; v < end; ++v)
      matchVertex(triangles, v, link, overfull[block]);
  };
  const bool complete = forEachBlock(vertex_count, context, match);
  listOverfull(joinBlocks(overfull));
  return complete;
}

void
TriangleAdjacency::matchVertex(const Triangles& triangles,
                               std::size_t vertex,
                               VertexLink& link,
                               std::vector<EdgeTriangle>& overfull)
{
  const auto* first = incident_.data() + offsets_[vertex];
  const auto* last = incident_.data() + offsets_[vertex + 1];
  const auto index = static_cast<pcl::index_t>(vertex);
  fans_[vertex] = link.match(triangles, index, first, last, across_.data());
  if (fans_[vertex] == Fan::OVERFULL)
    link.appendOverfull(index, first, overfull);
}

void
TriangleAdjacency::listOverfull(const std::vector<EdgeTriangle>& edge_triangles)
{
  for (const auto& [edge, triangle] : edge_triangles) {
    if (overfull_edges_.empty() || overfull_edges_.back() != edge) {
      overfull_edges_.push_back(edge);
      overfull_offsets_.push_back(overfull_offsets_.back());
    }
    overfull_triangles_.push_back(triangle);
    ++overfull_offsets_.back();
  }
}

void
TriangleAdjacency::renumber(const std::vector<pcl::index_t>& before, int threads)
{
  const std::size_t count = before.size();
  const auto offsets = std::exchange(offsets_, std::vector<std::uint32_t>(count + 1));
  const auto incident = std::exchange(incident_, Numbers(offsets.back()));
  const auto fans = std::exchange(fans_, std::vector<Fan>(count, Fan::NONE));
  for (std::size_t v = 0; v < count; ++v)
    if (before[v] >= 0) {
      const auto old = static_cast<std::size_t>(before[v]);
      offsets_[v + 1] = offsets[old + 1] - offsets[old];
      fans_[v] = fans[old];
    }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (before[v] >= 0)
        std::copy_n(incident.begin() + offsets[static_cast<std::size_t>(before[v])],
                    offsets_[v + 1] - offsets_[v],
                    incident_.begin() + offsets_[v]);
  };
  forEachBlock(count, {threads}, copy);
}

void
TriangleAdjacency::follow(const std::vector<std::uint8_t>& alive,
                          const Triangles& triangles,
                          std::size_t vertex_count,
                          int threads,
                          RunControl* control)
{
  const LoopContext context{threads, control, "adjacency", BLOCK_SIZE};
  const auto starts = blockStarts(alive.size(), context, [&](auto begin, auto end) {
    return countOf(alive, begin, end);
  });
  const std::size_t kept = alive.empty() ? triangleCount() : starts.back();
  if (!overfull_edges_.empty() || APPENDED_SHARE * (triangles.size() - kept) > kept)
    return build(triangles, vertex_count, threads, control);
  Numbers kept_as(alive.size());
  const auto number = [&](std::size_t block, std::size_t begin, std::size_t end) {
    auto next = static_cast<pcl::index_t>(starts[block]);
    for (std::size_t i = begin; i < end; ++i)
      kept_as[i] = alive[i] != 0 ? next++ : NONE;
  };
  std::vector<Corner> corners;
  for (std::size_t t = kept; t < triangles.size(); ++t)
    for (const auto vertex : triangles[t])
      corners.emplace_back(vertex, static_cast<pcl::index_t>(t));
  std::sort(corners.begin(), corners.end());
  if (!forEachBlock(alive.size(), context, number) ||
      !followAcross(kept_as, triangles.size(), context) ||
      !followLists(kept_as, corners, triangles, vertex_count, context))
    clear();
}

bool
TriangleAdjacency::followAcross(const Numbers& kept_as,
                                std::size_t triangle_count,
                                const LoopContext& context)
{
  const Numbers old = std::exchange(across_, Numbers(3 * triangle_count));
  const auto numberOf = [&](pcl::index_t t) {
    return t < 0 || kept_as.empty() ? t : kept_as[static_cast<std::size_t>(t)];
  };
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const pcl::index_t kept = numberOf(static_cast<pcl::index_t>(i));
          kept != NONE)
        std::transform(old.begin() + 3 * std::ptrdiff_t(i),
                       old.begin() + 3 * std::ptrdiff_t(i) + 3,
                       across_.begin() + 3 * std::ptrdiff_t{kept},
                       numberOf);
  };
  return forEachBlock(old.size() / 3, context, copy);
}

/** The lists, and chains anew around vertices whose lists have changed. */
bool
TriangleAdjacency::followLists(const Numbers& kept_as,
                               const std::vector<Corner>& corners,
                               const Triangles& triangles,
                               std::size_t vertex_count,
                               const LoopContext& context)
{
  auto offsets = std::exchange(offsets_, std::vector<std::uint32_t>(vertex_count + 1));
  offsets.resize(vertex_count + 1, offsets.back());
  const Numbers incident = std::exchange(incident_, Numbers(3 * triangles.size()));
  fans_.resize(vertex_count, Fan::NONE);
  const auto appendedAt = [&](std::size_t vertex) {
    return std::lower_bound(corners.begin(),
                            corners.end(),
                            Corner(static_cast<pcl::index_t>(vertex), NONE));
  };
  const auto each = [&](std::size_t begin, std::size_t end, const auto& visit) {
    auto appended = appendedAt(begin);
    for (std::size_t v = begin; v < end; ++v) {
      for (std::size_t i = offsets[v]; i < offsets[v + 1]; ++i)
        if (const auto kept = kept_as.empty()
                                  ? incident[i]
                                  : kept_as[static_cast<std::size_t>(incident[i])];
            kept != NONE)
          visit(v, kept);
      for (;
           appended != corners.end() && static_cast<std::size_t>(appended->first) == v;
           ++appended)
        visit(v, appended->second);
    }
  };
  forEachBlock(vertex_count, context, [&](auto, auto begin, auto end) {
    each(begin, end, [&](auto v, auto) { ++offsets_[v + 1]; });
  });
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  forEachBlock(vertex_count, context, [&](auto, auto begin, auto end) {
    auto* next = incident_.data() + offsets_[begin];
    each(begin, end, [&](auto, auto triangle) { *next++ = triangle; });
  });
  std::vector<std::vector<EdgeTriangle>> overfull(context.blockCount(vertex_count));
  const auto match = [&](std::size_t block, std::size_t begin, std::size_t end) {
    VertexLink link;
    auto appended = appendedAt(begin);
    for (std::size_t v = begin; v < end; ++v) {
      const bool gained =
          appended != corners.end() && static_cast<std::size_t>(appended->first) == v;
      if (gained || offsets[v + 1] - offsets[v] != offsets_[v + 1] - offsets_[v])
        matchVertex(triangles, v, link, overfull[block]);
      if (gained)
        appended = appendedAt(v + 1);
    }
  };
  const bool complete = forEachBlock(vertex_count, context, match);
  listOverfull(joinBlocks(overfull));
  return complete;
}

} // namespace pcl::ccaa
