// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far apart the points of a tile lie.
#include "out_of_core/point_spacing.h"

#include <pcl/surface_ccaa/impl/point_blocks.h>
#include <pcl/surface_ccaa/reconstruction_parameters.h>

#include "greedy/scan_lines.h"

#include <cmath>

namespace app {
namespace {

constexpr unsigned int NEAREST = 6;

/** Times that edges may be longer where points lie in lines, else 1. */
double
widening(const pcl::ccaa::RankedPoints& points, const pcl::ccaa::PointBlocks& blocks)
{
  // As many as a start can look at, and the point itself.
  constexpr unsigned int count = pcl::ccaa::NeighborRows::MOST + 1;
  const auto neighborsOf = [&](pcl::index_t rank) {
    std::vector<pcl::index_t> near;
    for (const pcl::ccaa::Neighbor& one :
         blocks.nearest(points.coordinates[static_cast<std::size_t>(rank)], count))
      if (one.point_index != rank)
        near.push_back(one.point_index);
    return near;
  };
  const double usual = pcl::ccaa::GreedyParameters().length_factor;
  return pcl::ccaa::reachInLines(pcl::ccaa::findScanLines(points, neighborsOf), usual) /
         usual;
}

} // namespace

std::vector<float>
spacingsOf(const pcl::ccaa::RankedPoints& points, int threads)
{
  std::vector<float> spacings(points.size(), 0.0F);
  if (points.size() <= NEAREST)
    return spacings;
  pcl::ccaa::PointBlocks blocks;
  blocks.build({points.coordinates.front().data(), 3, points.size()}, threads);
  const auto table =
      blocks.allNearest(NEAREST, pcl::ccaa::PointBlocks::Distances::KEEP, threads);
  const double wider = widening(points, blocks);
  for (std::size_t rank = 0; rank < blocks.size(); ++rank) {
    float& spacing = spacings[static_cast<std::size_t>(blocks.order()[rank])];
    for (unsigned int i = 0; i < NEAREST; ++i)
      spacing += std::sqrt(table->sqrDistances(rank)[i]) / float(NEAREST);
    if (wider > 1.0)
      spacing *= static_cast<float>(wider);
  }
  return spacings;
}

} // namespace app
