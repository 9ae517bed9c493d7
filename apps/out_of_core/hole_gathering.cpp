// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the holes that a tile has to repair.
#include "out_of_core/hole_gathering.h"

#include "mesh/sort_unique.h"
#include "out_of_core/tile_points.h"
#include "out_of_core/tile_steps.h"

#include <algorithm>

namespace app {

using pcl::ccaa::Box;
using pcl::ccaa::Position;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

HoleGathering::HoleGathering(const TilePlan& plan, std::size_t tile) : plan_(plan)
{
  AllHoles all = readHoles(plan);
  std::vector<Box> regions;
  for (const HoleLoop& loop : all.loops) {
    regions.push_back(loop.region);
    if (loop.tile != tile)
      continue;
    if (clusters_.empty() || loop.cluster != clusters_.back().number)
      clusters_.emplace_back();
    HoleCluster& cluster = clusters_.back();
    cluster.number = loop.cluster;
    cluster.edges.insert(cluster.edges.end(),
                         all.edges.begin() + static_cast<std::ptrdiff_t>(loop.begin),
                         all.edges.begin() + static_cast<std::ptrdiff_t>(loop.end));
    regions_.push_back(loop.region);
    cluster_of_.push_back(static_cast<std::uint32_t>(clusters_.size() - 1));
  }
  for (HoleCluster& cluster : clusters_)
    std::sort(cluster.edges.begin(), cluster.edges.end());
  loops_ = std::move(all.loops);
  tree_ = pcl::ccaa::BoxTree(regions);
  own_tree_ = pcl::ccaa::BoxTree(regions_);
  for (std::size_t part = 0; part < plan.tiling.tiles.size(); ++part) {
    const Box around = plan.tiling.tiles[part].surroundings();
    if (std::any_of(regions_.begin(), regions_.end(), [&](const Box& region) {
          return around.intersects(region);
        }))
      parts_.insert(part);
  }
}

std::vector<HoleCluster>
HoleGathering::gather()
{
  const pcl::ccaa::Sides sides = readSides(plan_);
  for (const std::size_t part : parts_)
    addPart(part, sides.components_of[part]);
  for (HoleCluster& cluster : clusters_) {
    for (const WideTriangle& triangle : cluster.triangles)
      cluster.points.insert(cluster.points.end(), triangle.begin(), triangle.end());
    pcl::ccaa::sortUnique(cluster.points);
  }
  return std::move(clusters_);
}

void
HoleGathering::addPart(std::size_t part, const std::vector<std::uint64_t>& components)
{
  const TileSurface surface = readSurface(plan_, part);
  const PointClusters points = placePoints(part, surface);
  const pcl::ccaa::Tile& own = plan_.tiling.tiles[part];
  std::size_t piece = 0;
  std::set<std::uint32_t> clusters;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    while (t >= surface.piece_ends[piece])
      ++piece;
    const CoreTriangle& triangle = surface.triangles[t];
    clusters.clear();
    for (const std::uint32_t corner : triangle)
      for (auto at = std::lower_bound(
               points.begin(), points.end(), std::make_pair(corner, std::uint32_t{0}));
           at != points.end() && at->first == corner;
           ++at)
        clusters.insert(at->second);
    for (const std::uint32_t c : clusters) {
      clusters_[c].components.push_back(components[piece]);
      clusters_[c].triangles.push_back(surface.wideOf(own, triangle));
    }
  }
}

/** Adds the points of a part to their clusters. */
HoleGathering::PointClusters
HoleGathering::placePoints(std::size_t part, const TileSurface& surface)
{
  const pcl::ccaa::Tile& own = plan_.tiling.tiles[part];
  PointClusters placed;
  const TilePoints points(plan_, part);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    points.forEachIn(regions_[r], [&](std::size_t i) {
      placed.emplace_back(static_cast<std::uint32_t>(i), cluster_of_[r]);
    });
  pcl::ccaa::sortUnique(placed);
  for (const auto& [i, cluster] : placed)
    clusters_[cluster].points.push_back(own.first + i);
  auto next = static_cast<std::uint32_t>(own.count);
  forPoints(plan_,
            surface.foreign.begin(),
            surface.foreign.end(),
            [&](std::size_t, const TilePoints& others, std::size_t i) {
              const Position position = others.position(i);
              own_tree_.forEachMeeting(Box(position, position), [&](pcl::index_t r) {
                const auto region = static_cast<std::size_t>(r);
                if (regions_[region].contains(position))
                  placed.emplace_back(next, cluster_of_[region]);
              });
              ++next;
            });
  pcl::ccaa::sortUnique(placed);
  return placed;
}

bool
HoleGathering::isNearOthers(const HoleCluster& cluster, const Box& box) const
{
  return tree_.anyMeeting(box, [&](pcl::index_t index) {
    const HoleLoop& loop = loops_[static_cast<std::size_t>(index)];
    return loop.cluster != cluster.number && loop.region.intersects(box);
  });
}

bool
HoleGathering::isKnown(const HoleCluster& cluster, const Position& position) const
{
  return tree_.anyMeeting(Box(position, position), [&](pcl::index_t index) {
    const HoleLoop& loop = loops_[static_cast<std::size_t>(index)];
    return loop.cluster == cluster.number && loop.region.contains(position);
  });
}

} // namespace app
