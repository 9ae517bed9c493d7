// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: gaps that have nothing to do with each other.
#include "advancing_front/open_regions.h"

#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace pcl::ccaa {
namespace {

/** Operations for a point of a region, in each of two steps. */
constexpr std::uint64_t REGION_WORK = 30;

void
joinNeighbors(const OpenSurface& open, double reach, DisjointSets& sets)
{
  for (std::size_t i = 0; i < open.open_points; ++i) {
    const auto point = static_cast<pcl::index_t>(i);
    for (unsigned int j = 0; j < open.neighbors.count(point); ++j) {
      const pcl::index_t near = open.neighbors.row(point)[j];
      const auto n = static_cast<std::size_t>(near);
      const double limit = reach * std::max(open.spacings[i], open.spacings[n]);
      if ((open.positions[i] - open.positions[n]).norm() <= limit)
        sets.join(i, n);
    }
  }
}

} // namespace

std::vector<std::vector<pcl::index_t>>
openRegions(const OpenSurface& open, double reach)
{
  DisjointSets sets(open.open_points);
  const auto is_open = [&](pcl::index_t vertex) {
    return static_cast<std::size_t>(vertex) < open.open_points;
  };
  for (const Triangle& t : open.rim)
    for (std::size_t i = 0; i < 3; ++i)
      if (is_open(t[i]) && is_open(t[(i + 1) % 3]))
        sets.join(static_cast<std::size_t>(t[i]),
                  static_cast<std::size_t>(t[(i + 1) % 3]));
  joinNeighbors(open, reach, sets);
  std::vector<std::vector<pcl::index_t>> regions;
  std::vector<std::size_t> region_of_head(open.open_points);
  for (std::size_t i = 0; i < open.open_points; ++i) {
    const std::size_t head = sets.find(i);
    if (head == i) {
      region_of_head[i] = regions.size();
      regions.emplace_back();
    }
    regions[region_of_head[head]].push_back(static_cast<pcl::index_t>(i));
  }
  return regions;
}

std::vector<std::vector<pcl::index_t>>
rimOfRegions(const OpenSurface& open,
             const std::vector<std::vector<pcl::index_t>>& regions)
{
  std::vector<std::size_t> region_of_point(open.open_points);
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (const pcl::index_t point : regions[r])
      region_of_point[static_cast<std::size_t>(point)] = r;
  std::vector<std::vector<pcl::index_t>> rims(regions.size());
  for (std::size_t t = 0; t < open.rim.size(); ++t)
    for (const pcl::index_t corner : open.rim[t])
      if (static_cast<std::size_t>(corner) < open.open_points) {
        rims[region_of_point[static_cast<std::size_t>(corner)]].push_back(
            static_cast<pcl::index_t>(t));
        break;
      }
  return rims;
}

OpenSurface
regionOf(const OpenSurface& open,
         const std::vector<pcl::index_t>& points,
         const std::vector<pcl::index_t>& rim,
         std::vector<pcl::index_t>& vertices,
         RunControl* control)
{
  WorkCount work(control);
  if (points.size() == open.open_points) {
    vertices.resize(open.positions.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    return open;
  }
  OpenSurface region;
  region.open_points = points.size();
  region.removed = open.removed;
  region.largest_room = open.largest_room;
  for (const pcl::index_t t : rim)
    region.rim.push_back(open.rim[static_cast<std::size_t>(t)]);
  vertices = points;
  const IndexSet numbers = numberRim(region.rim, vertices);
  work.add(REGION_WORK * points.size());
  for (const pcl::index_t vertex : vertices)
    region.positions.push_back(open.positions[static_cast<std::size_t>(vertex)]);
  const unsigned int k = open.neighbors.k;
  region.neighbor_table.assign(points.size() * k, NeighborRows::NONE);
  for (std::size_t i = 0; i < points.size(); ++i) {
    work.add(REGION_WORK);
    region.spacings.push_back(open.spacings[static_cast<std::size_t>(points[i])]);
    if (!open.normals.empty())
      region.normals.push_back(open.normals[static_cast<std::size_t>(points[i])]);
    if (!open.outward.empty())
      region.outward.push_back(open.outward[static_cast<std::size_t>(points[i])]);
    std::size_t place = i * k;
    for (unsigned int j = 0; j < open.neighbors.count(points[i]); ++j)
      if (const pcl::index_t near = numbers.placeOf(open.neighbors.row(points[i])[j]);
          near >= 0 && static_cast<std::size_t>(near) < points.size())
        region.neighbor_table[place++] = near;
  }
  region.neighbors = {region.neighbor_table.data(), k};
  return region;
}

} // namespace pcl::ccaa
