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
TriangleAdjacency::keep(const std::vector<std::uint8_t>& alive,
                        const Triangles& left,
                        int threads,
                        RunControl* control)
{
  const LoopContext context{threads, control, "adjacency", BLOCK_SIZE};
  UninitializedVector<pcl::index_t> kept_as(alive.size());
  const auto starts = blockStarts(alive.size(), context, [&](auto begin, auto end) {
    return flagged(alive, begin, end);
  });
  const auto number = [&](std::size_t block, std::size_t begin, std::size_t end) {
    auto next = static_cast<pcl::index_t>(starts[block]);
    for (std::size_t i = begin; i < end; ++i)
      kept_as[i] = alive[i] != 0 ? next++ : NONE;
  };
  if (!forEachBlock(alive.size(), context, number) || !keepAcross(kept_as, context) ||
      !keepLists(kept_as, left, context))
    clear();
}

void
TriangleAdjacency::renumber(const std::vector<pcl::index_t>& before,
                            std::size_t vertex_count,
                            int threads)
{
  const auto offsets =
      std::exchange(offsets_, std::vector<std::uint32_t>(vertex_count + 1));
  const auto incident =
      std::exchange(incident_, UninitializedVector<pcl::index_t>(offsets.back()));
  const auto fans = std::exchange(fans_, std::vector<Fan>(vertex_count, Fan::NONE));
  const auto old = [&](std::size_t vertex) {
    return static_cast<std::size_t>(before[vertex]);
  };
  for (std::size_t v = 0; v < before.size(); ++v)
    offsets_[v + 1] = offsets[old(v) + 1] - offsets[old(v)];
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::copy(incident.begin() + offsets[old(v)],
                incident.begin() + offsets[old(v) + 1],
                incident_.begin() + offsets_[v]);
      fans_[v] = fans[old(v)];
    }
  };
  forEachBlock(before.size(), {threads}, copy);
}

void
TriangleAdjacency::follow(const std::vector<std::uint8_t>& alive,
                          const Triangles& triangles,
                          int threads,
                          RunControl* control)
{
  const std::size_t kept = flagged(alive, 0, alive.size());
  if (isAppendedAnew(kept, triangles.size()))
    return build(triangles, vertexCount(), threads, control);
  if (kept < alive.size())
    keep(alive, triangles, threads, control);
  if (kept < triangles.size() && (control == nullptr || !control->cancelled()))
    append(triangles, vertexCount(), threads, control);
}

/** Whether so many triangles more are better built than appended. */
bool
TriangleAdjacency::isAppendedAnew(std::size_t before, std::size_t after) const
{
  return !overfull_edges_.empty() || APPENDED_SHARE * (after - before) > before;
}

bool
TriangleAdjacency::keepAcross(const UninitializedVector<pcl::index_t>& kept_as,
                              const LoopContext& context)
{
  UninitializedVector<pcl::index_t> across(across_.size());
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (kept_as[i] == NONE)
        continue;
      auto slot = across.begin() + 3 * std::ptrdiff_t{kept_as[i]};
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
        *slot++ =
            across_[k] < 0 ? across_[k] : kept_as[static_cast<std::size_t>(across_[k])];
    }
  };
  const bool complete = forEachBlock(kept_as.size(), context, copy);
  across_ = std::move(across);
  return complete;
}

/** And chains anew around vertices that have lost a triangle. */
bool
TriangleAdjacency::keepLists(const UninitializedVector<pcl::index_t>& kept_as,
                             const Triangles& left,
                             const LoopContext& context)
{
  const auto offsets = std::exchange(offsets_, std::vector<std::uint32_t>(1));
  const auto incident = std::exchange(incident_, {});
  offsets_.resize(offsets.size());
  const auto eachAt = [&](std::size_t vertex, const auto& visit) {
    for (std::size_t i = offsets[vertex]; i < offsets[vertex + 1]; ++i)
      if (const auto kept = kept_as[static_cast<std::size_t>(incident[i])];
          kept != NONE)
        visit(kept);
  };
  const auto count = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      eachAt(v, [&](pcl::index_t) { ++offsets_[v + 1]; });
  };
  forEachBlock(fans_.size(), context, count);
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  incident_.resize(offsets_.back());
  across_.resize(offsets_.back());
  const auto fill = [&](std::size_t, std::size_t begin, std::size_t end) {
    auto* next = incident_.data() + offsets_[begin];
    for (std::size_t v = begin; v < end; ++v)
      eachAt(v, [&](pcl::index_t kept) { *next++ = kept; });
  };
  const auto match = [&](std::size_t, std::size_t begin, std::size_t end) {
    VertexLink link;
    std::vector<EdgeTriangle> overfull; // none is made by deletion
    for (std::size_t v = begin; v < end; ++v)
      if (offsets[v + 1] - offsets[v] != offsets_[v + 1] - offsets_[v])
        matchVertex(left, v, link, overfull);
  };
  return forEachBlock(fans_.size(), context, fill) &&
         forEachBlock(fans_.size(), context, match);
}

void
TriangleAdjacency::append(const Triangles& triangles,
                          std::size_t vertex_count,
                          int threads,
                          RunControl* control)
{
  const std::size_t before = triangleCount();
  if (isAppendedAnew(before, triangles.size()))
    return build(triangles, vertex_count, threads, control);
  std::vector<Corner> corners;
  for (std::size_t t = before; t < triangles.size(); ++t)
    for (const auto vertex : triangles[t])
      corners.emplace_back(vertex, static_cast<pcl::index_t>(t));
  std::sort(corners.begin(), corners.end());
  offsets_.resize(vertex_count + 1, offsets_.back());
  insertCorners(corners);
  across_.resize(3 * triangles.size());
  fans_.resize(vertex_count, Fan::NONE);
  VertexLink link;
  std::vector<EdgeTriangle> overfull;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (i == 0 || corners[i].first != corners[i - 1].first)
      matchVertex(
          triangles, static_cast<std::size_t>(corners[i].first), link, overfull);
  listOverfull(overfull);
}

/** \brief Put triangles at the ends of the lists of their vertices.
 * \param[in] corners ascending */
void
TriangleAdjacency::insertCorners(const std::vector<Corner>& corners)
{
  std::size_t end = incident_.size(); // of what has not moved yet
  incident_.resize(end + corners.size());
  for (std::size_t i = corners.size(); i-- > 0;) {
    const auto [vertex, triangle] = corners[i];
    const std::size_t list_end = offsets_[static_cast<std::size_t>(vertex) + 1];
    std::copy_backward(incident_.begin() + static_cast<std::ptrdiff_t>(list_end),
                       incident_.begin() + static_cast<std::ptrdiff_t>(end),
                       incident_.begin() + static_cast<std::ptrdiff_t>(end + i + 1));
    incident_[list_end + i] = triangle;
    end = list_end;
  }
  std::uint32_t inserted = 0;
  for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
    while (inserted < corners.size() &&
           static_cast<std::size_t>(corners[inserted].first) == v)
      ++inserted;
    offsets_[v + 1] += inserted;
  }
}

} // namespace pcl::ccaa
