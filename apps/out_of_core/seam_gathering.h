// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the places that a tile has to close.
#pragma once

#include "mesh/box_tree.h"
#include "out_of_core/tile_files.h"

#include <map>
#include <set>
#include <vector>

namespace app {

/** \brief What some tiles have made of their groups, in the order in which they did;
 * what was removed is ascending. */
std::vector<ClosedTile>
readAllClosed(const TilePlan& plan, const std::set<std::size_t>& closers);

/** \brief The border triangles of a tile after that. */
std::vector<pcl::ccaa::WideTriangle>
trianglesAfter(const TilePlan& plan,
               std::size_t tile,
               const std::vector<ClosedTile>& closed);

/** \brief The groups of disputes that a tile closes, with the points and triangles
 * around them, from all tiles that have any. */
class SeamGathering {
public:
  SeamGathering(const TilePlan& plan, std::size_t tile);

  /** \brief Groups of the tile. */
  std::size_t
  size() const
  {
    return surroundings_.size();
  }

  /** \brief Tiles whose meshes read() reads. */
  const std::set<std::size_t>&
  parts() const
  {
    return parts_;
  }

  /** \brief Tiles with lower numbers that close other parts of a group before. */
  const std::set<std::size_t>&
  earlier() const
  {
    return earlier_;
  }

  /** \brief Read what is near the disputes. */
  void
  read();

  /** \brief Points within four reaches of a dispute of a group, the triangles that the
   * tiles agree about of these and of what passes there, and the other corners of
   * those. Open are the disputes, and within one reach the points without triangles.
   * So are disputes of other parts of the group that may share a refused triangle with
   * one of this part: no part alone has all corners of it.
   * Positions are relative to the tile's corner. \param[out] wide the points of the
   * seam in the whole, ascending
   */
  pcl::ccaa::Seam
  gather(std::size_t group, std::vector<pcl::ccaa::WideIndex>& wide) const;

private:
  struct Nearness {
    double in_reaches = 0.0; /**< distance from the nearest dispute, in reaches of it */
    double room = 0.0;       /**< how far it is to the end of a dispute's room */
    bool is_refused = false; /**< it is as near as a corner of a refused triangle: half
                                  the room at most */
  };

  struct Known {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::vector<std::size_t> groups; /**< that it is near */
    bool lacks = false; /**< a triangle, as another corner of it is not known */
  };

  /** A triangle, and groups of which it comes near a dispute, whatever its corners. */
  struct Passing {
    pcl::ccaa::WideTriangle triangle;
    std::vector<std::size_t> groups; /**< ascending */
  };

  struct Surroundings {
    std::map<pcl::ccaa::WideIndex, Nearness> near;
    std::vector<pcl::ccaa::WideTriangle> triangles;
  };

  void
  findParts();
  std::map<std::size_t, Nearness>
  nearness(const Eigen::Vector3d& position) const;
  void
  addPoint(const pcl::ccaa::BorderPoint& point);
  std::vector<std::size_t>
  groupsPassed(const pcl::ccaa::WideTriangle& triangle,
               const pcl::ccaa::BorderPoints& own) const;
  void
  addCorners(std::vector<pcl::ccaa::WideIndex> missing);
  void
  addTriangle(const Passing& passing);

  const TilePlan& plan_;
  std::size_t tile_;
  std::vector<PlacedDispute> disputes_; /**< group by group */
  std::vector<std::size_t> group_of_;   /**< of each of them */
  std::set<std::size_t> parts_;         /**< tiles that may have something near them */
  std::set<pcl::ccaa::WideIndex> of_others_; /**< disputes of other parts around */
  std::set<std::size_t> earlier_; /**< that have closed what is around them */
  pcl::ccaa::BoxTree tree_;       /**< over what is near each dispute */
  std::map<pcl::ccaa::WideIndex, Known> known_;
  std::vector<Surroundings> surroundings_; /**< by group */
};

} // namespace app
