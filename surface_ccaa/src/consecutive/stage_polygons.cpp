// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: taking over the polygons that any algorithm hands out.
#include "consecutive/stage_polygons.h"

#include "mesh/polygon_access.h"
#include "mesh/triangle_adjacency.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::ccaa {
namespace {

bool
isInRange(pcl::index_t corner, std::size_t point_count)
{
  return corner >= 0 && static_cast<std::size_t>(corner) < point_count;
}

bool
isTriangle(const pcl::Indices& corners, std::size_t point_count)
{
  return corners.size() == 3 && isInRange(corners[0], point_count) &&
         isInRange(corners[1], point_count) && isInRange(corners[2], point_count) &&
         corners[0] != corners[1] && corners[1] != corners[2] &&
         corners[2] != corners[0];
}

/** \brief For polygons with any number of corners. */
bool
isSound(const pcl::Indices& corners, std::size_t point_count)
{
  if (corners.size() < 3 ||
      !std::all_of(corners.begin(), corners.end(), [point_count](pcl::index_t corner) {
        return isInRange(corner, point_count);
      }))
    return false;
  pcl::Indices sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

} // namespace

std::optional<Triangles>
readTriangles(const std::vector<pcl::Vertices>& polygons,
              std::size_t point_count,
              const LoopContext& context)
{
  Triangles triangles(polygons.size());
  std::vector<std::uint8_t> good(context.blockCount(polygons.size()), 0);
  const auto read = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const pcl::Indices& corners = polygons[i].vertices;
      if (!isTriangle(corners, point_count))
        return;
      std::copy_n(corners.begin(), 3, triangles[i].begin());
    }
    good[block] = 1;
  };
  if (forEachBlock(polygons.size(), context, read) &&
      std::find(good.begin(), good.end(), 0) == good.end())
    return triangles;
  return {};
}

std::size_t
makeTriangles(const std::vector<pcl::Vertices>& polygons,
              const pcl::Indices* selection,
              std::size_t point_count,
              const LoopContext& context,
              Triangles& triangles)
{
  std::size_t left_out = 0;
  const std::size_t limit = selection == nullptr ? point_count : selection->size();
  if (auto read = readTriangles(polygons, limit, context))
    triangles = std::move(*read);
  else
    for (const pcl::Vertices& polygon : polygons) {
      const pcl::Indices& corners = polygon.vertices;
      const bool is_sound = isSound(corners, limit);
      left_out += is_sound ? 0 : 1;
      for (std::size_t i = 2; is_sound && i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  if (selection != nullptr)
    renumber(*selection, context, triangles);
  return left_out;
}

std::vector<PointRole>
findPointRoles(const Triangles& triangles,
               std::size_t point_count,
               const LoopContext& context)
{
  std::vector<PointRole> roles(point_count, PointRole::FREE);
  TriangleAdjacency adjacency;
  adjacency.build(triangles, point_count, context.threads, context.control);
  const std::vector<Fan>& fans = adjacency.fans();
  for (std::size_t i = 0; i < fans.size(); ++i)
    if (fans[i] != Fan::NONE)
      roles[i] = fans[i] == Fan::CLOSED ? PointRole::INTERNAL : PointRole::BOUNDARY;
  return roles;
}

} // namespace pcl::ccaa
