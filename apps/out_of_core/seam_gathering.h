// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the places that a tile has to close.
#pragma once

#include "out_of_core/tile_files.h"

#include <map>
#include <set>
#include <vector>

namespace app {

/** \brief The groups of disputes of one tile with the points and triangles around them,
 * from all tiles that have any. */
class SeamGathering {
public:
  SeamGathering(const TilePlan& plan, std::size_t tile);

  bool
  empty() const
  {
    return disputes_.empty();
  }

  /** \brief Tiles whose meshes gather() reads. */
  const std::set<std::size_t>&
  parts() const
  {
    return parts_;
  }

  /** \brief Points within four reaches of a dispute, the triangles of these that the
   * tiles agree about, and the other corners of those. Open are the disputes, and
   * within one reach the points without triangles. Positions are relative to the tile's
   * corner.
   */
  pcl::ccaa::Seam
  gather();

  /** \brief The corners of a triangle of the seam in the whole. */
  pcl::ccaa::WideTriangle
  toWide(const pcl::ccaa::Triangle& triangle) const
  {
    return {wide_[std::size_t(triangle[0])],
            wide_[std::size_t(triangle[1])],
            wide_[std::size_t(triangle[2])]};
  }

private:
  using GridPlace = std::array<std::int64_t, 3>;

  GridPlace
  gridPlace(const Eigen::Vector3d& position, std::size_t neighbor) const;
  double
  nearness(const Eigen::Vector3d& position) const;
  void
  readParts();

  const TilePlan& plan_;
  std::size_t tile_;
  std::vector<PlacedDispute> disputes_; /**< ascending */
  std::set<std::size_t> parts_;         /**< tiles that may have something near them */
  double edge_ = 0.0;                   /**< of the grid's cells */
  std::map<GridPlace, std::vector<std::size_t>> grid_; /**< disputes by cell */
  std::map<pcl::ccaa::WideIndex, Eigen::Vector3d> known_;
  std::map<pcl::ccaa::WideIndex, double> near_; /**< with their nearness */
  std::vector<pcl::ccaa::WideTriangle> triangles_;
  std::vector<pcl::ccaa::WideIndex> wide_; /**< the points of the seam, ascending */
};

} // namespace app
