// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: taking over the polygons that any algorithm hands out.
#include "consecutive/stage_polygons.h"

#include "mesh/triangle_adjacency.h"

#include <algorithm>
#include <cstdint>

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

bool
areTriangles(const std::vector<pcl::Vertices>& polygons,
             std::size_t point_count,
             const LoopContext& context)
{
  std::vector<std::uint8_t> good(context.blockCount(polygons.size()), 0);
  const auto check = [&](std::size_t block, std::size_t begin, std::size_t end) {
    bool all = true;
    for (std::size_t i = begin; i < end; ++i)
      all = all && isTriangle(polygons[i].vertices, point_count);
    good[block] = all ? 1 : 0;
  };
  return forEachBlock(polygons.size(), context, check) &&
         std::find(good.begin(), good.end(), 0) == good.end();
}

std::size_t
makeTriangles(std::vector<pcl::Vertices>& polygons,
              std::size_t point_count,
              const LoopContext& context)
{
  if (areTriangles(polygons, point_count, context))
    return 0;
  std::size_t left_out = 0;
  std::vector<pcl::Vertices> triangles;
  triangles.reserve(polygons.size());
  for (pcl::Vertices& polygon : polygons) {
    const pcl::Indices& corners = polygon.vertices;
    if (!isSound(corners, point_count)) {
      ++left_out;
      continue;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.emplace_back();
      triangles.back().vertices = {corners[0], corners[i - 1], corners[i]};
    }
  }
  polygons = std::move(triangles);
  return left_out;
}

void
mapToCloud(const pcl::Indices& selection, std::vector<pcl::Vertices>& polygons)
{
  for (pcl::Vertices& polygon : polygons)
    for (pcl::index_t& corner : polygon.vertices)
      corner = isInRange(corner, selection.size())
                   ? selection[static_cast<std::size_t>(corner)]
                   : -1;
}

Triangles
toIndexTriangles(const std::vector<pcl::Vertices>& polygons, const LoopContext& context)
{
  Triangles triangles(polygons.size());
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      std::copy_n(polygons[i].vertices.begin(), 3, triangles[i].begin());
  };
  forEachBlock(polygons.size(), context, copy);
  return triangles;
}

std::vector<PointRole>
findPointRoles(const std::vector<pcl::Vertices>& polygons,
               std::size_t point_count,
               const LoopContext& context)
{
  std::vector<PointRole> roles(point_count, PointRole::FREE);
  TriangleAdjacency adjacency;
  adjacency.build(toIndexTriangles(polygons, context),
                  point_count,
                  context.threads,
                  context.control);
  const std::vector<Fan>& fans = adjacency.fans();
  for (std::size_t i = 0; i < fans.size(); ++i)
    if (fans[i] != Fan::NONE)
      roles[i] = fans[i] == Fan::CLOSED ? PointRole::INTERNAL : PointRole::BOUNDARY;
  return roles;
}

} // namespace pcl::ccaa
