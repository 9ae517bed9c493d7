// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the holes that a tile has to repair.
#pragma once

#include "mesh/box_tree.h"
#include "out_of_core/repair_files.h"
#include "out_of_core/tile_files.h"

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace app {

/** \brief Loops that are repaired together, and the surface around them. */
struct HoleCluster {
  std::vector<std::array<pcl::ccaa::WideIndex, 2>> edges; /**< open ones, ascending */
  std::vector<pcl::ccaa::WideIndex>
      points; /**< around them, ascending, and all corners */
  std::vector<pcl::ccaa::WideTriangle> triangles; /**< outward */
  std::vector<std::uint64_t> components;          /**< of the triangles */
  std::uint64_t number = 0; /**< among the clusters of all tiles */
};

/** \brief The clusters of one tile, from all tiles that have a part of them. */
class HoleGathering {
public:
  HoleGathering(const TilePlan& plan, std::size_t tile);

  /** \brief Tiles whose surface gather() reads, beside the points of those around. */
  const std::set<std::size_t>&
  parts() const
  {
    return parts_;
  }

  /** \brief Points within the regions of a cluster's loops, the triangles of which a
   * corner is among them, and their other corners. */
  std::vector<HoleCluster>
  gather();

  /** \brief Whether a box meets the region of a loop of another cluster, whose new
   * triangles may be there, too. */
  bool
  isNearOthers(const HoleCluster& cluster, const pcl::ccaa::Box& box) const;

  /** \brief Whether a position lies within one of the cluster's own: outside of them
   * the given surface is not known. */
  bool
  isKnown(const HoleCluster& cluster, const pcl::ccaa::Position& position) const;

private:
  /** Point of a surface and cluster, ascending. */
  using PointClusters = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  void
  addPart(std::size_t part, const std::vector<std::uint64_t>& components);
  PointClusters
  placePoints(std::size_t part, const TileSurface& surface);

  const TilePlan& plan_;
  std::vector<HoleLoop> loops_; /**< of all tiles */
  pcl::ccaa::BoxTree tree_;     /**< over their regions */
  std::vector<HoleCluster> clusters_;
  std::vector<pcl::ccaa::Box> regions_;   /**< of the loops of this tile */
  std::vector<std::uint32_t> cluster_of_; /**< of these: index into clusters_ */
  pcl::ccaa::BoxTree own_tree_;           /**< over these regions */
  std::set<std::size_t> parts_;
};

} // namespace app
