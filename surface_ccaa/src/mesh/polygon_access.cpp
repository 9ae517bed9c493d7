// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PCL polygons to index triangles and back.
#include "mesh/polygon_access.h"

#include "mesh/vertex_numbering.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace pcl::ccaa {
namespace {

/** \brief Marks a triangle of an invalid polygon in its first corner. */
constexpr pcl::index_t INVALID = -1;

std::size_t
triangleCount(const PolygonView::Corners& corners)
{
  return corners.size() < 3 ? 0 : corners.size() - 2;
}

/** \brief Flags of the points that are not finite; empty when all are. */
std::vector<std::uint8_t>
flagNonFinite(const PointView& points, const LoopContext& context)
{
  std::vector<std::vector<std::size_t>> parts(context.blockCount(points.size()));
  const auto find = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!points[i].allFinite())
        parts[block].push_back(i);
  };
  forEachBlock(points.size(), context, find);
  const auto found = joinBlocks(parts);
  std::vector<std::uint8_t> flags(found.empty() ? 0 : points.size(), 0);
  for (const auto point_index : found)
    flags[point_index] = 1;
  return flags;
}

/** \brief Decides which polygons are sound. */
class PolygonCheck {
public:
  PolygonCheck(const PointView& points, const std::vector<std::uint8_t>& non_finite)
  : point_count_(points.size()), non_finite_(non_finite)
  {}

  bool
  isValid(const PolygonView::Corners& corners)
  {
    for (const auto corner : corners) {
      const auto point_index = static_cast<std::size_t>(corner);
      if (corner < 0 || point_index >= point_count_ ||
          (!non_finite_.empty() && non_finite_[point_index] != 0))
        return false;
    }
    if (corners.size() == 3)
      return corners[0] != corners[1] && corners[1] != corners[2] &&
             corners[2] != corners[0];
    sorted_.assign(corners.begin(), corners.end());
    std::sort(sorted_.begin(), sorted_.end());
    return std::adjacent_find(sorted_.begin(), sorted_.end()) == sorted_.end();
  }

private:
  std::size_t point_count_;
  const std::vector<std::uint8_t>& non_finite_;
  std::vector<pcl::index_t> sorted_;
};

} // namespace

PolygonTriangles
readPolygons(const PolygonView& polygons,
             const PointView& points,
             const LoopContext& context)
{
  const auto non_finite = flagNonFinite(points, context);
  const auto starts = blockStarts(polygons.size(), context, [&](auto begin, auto end) {
    std::size_t triangles = 0;
    for (std::size_t i = begin; i < end; ++i)
      triangles += triangleCount(polygons[i]);
    return triangles;
  });
  std::vector<std::size_t> invalid(starts.size(), 0);
  PolygonTriangles mesh;
  mesh.triangles.resize(starts.back());
  const auto read = [&](std::size_t block, std::size_t begin, std::size_t end) {
    PolygonCheck check(points, non_finite);
    Triangle* out = mesh.triangles.data() + starts[block];
    for (std::size_t i = begin; i < end; ++i) {
      const PolygonView::Corners corners = polygons[i];
      const bool valid = corners.size() > 2 && check.isValid(corners);
      invalid[block] += valid ? 0 : 1;
      for (std::size_t corner = 2; corner < corners.size(); ++corner)
        *out++ = valid ? Triangle{corners[0], corners[corner - 1], corners[corner]}
                       : Triangle{INVALID, INVALID, INVALID};
    }
  };
  if (context.cancelled() || !forEachBlock(polygons.size(), context, read))
    return mesh;
  mesh.invalid_polygons =
      std::accumulate(invalid.begin(), invalid.end(), std::size_t{0});
  if (mesh.invalid_polygons > 0) {
    const auto is_invalid = [](const Triangle& triangle) {
      return triangle[0] == INVALID;
    };
    auto& all = mesh.triangles;
    all.erase(std::remove_if(all.begin(), all.end(), is_invalid), all.end());
  }
  mesh.point_of_vertex = numberVertices(points.size(), context, mesh.triangles);
  return mesh;
}

Triangles
fanTriangles(const PolygonView& polygons)
{
  Triangles triangles;
  triangles.reserve(polygons.size());
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
    const PolygonView::Corners corners = polygons[polygon];
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return triangles;
}

void
writePolygons(const Triangles& triangles,
              const LoopContext& context,
              std::vector<pcl::Vertices>& polygons)
{
  polygons.resize(triangles.size());
  const auto write = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      polygons[i].vertices.assign(triangles[i].begin(), triangles[i].end());
  };
  forEachBlock(triangles.size(), context, write);
}

void
renumber(const std::vector<pcl::index_t>& point_of_vertex,
         const LoopContext& context,
         Triangles& triangles)
{
  const auto write = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (pcl::index_t& corner : triangles[i])
        corner = point_of_vertex[static_cast<std::size_t>(corner)];
  };
  forEachBlock(triangles.size(), context, write);
}

void
handOut(Triangles triangles,
        const std::vector<pcl::index_t>& point_of_vertex,
        const LoopContext& context,
        TriangleHandoff* handoff,
        std::vector<pcl::Vertices>& polygons)
{
  renumber(point_of_vertex, context, triangles);
  if (handoff != nullptr)
    handoff->made = std::move(triangles);
  else
    writePolygons(triangles, context, polygons);
}

Triangles
liveTriangles(const Triangles& triangles,
              const AliveFlags& alive,
              const LoopContext& context)
{
  const auto starts = blockStarts(triangles.size(), context, [&](auto begin, auto end) {
    return countOf(alive, begin, end);
  });
  Triangles live(starts.back());
  const auto copy = [&](std::size_t block, std::size_t begin, std::size_t end) {
    Triangle* out = live.data() + starts[block];
    for (std::size_t i = begin; i < end; ++i)
      if (alive[i] != 0)
        *out++ = triangles[i];
  };
  forEachBlock(triangles.size(), context, copy);
  return live;
}

} // namespace pcl::ccaa
