// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PCL's KdTree of floats over positions anywhere, of any
// size.
#pragma once

#include <pcl/search/search.h>
#include <pcl/point_types.h>

#include "icadm/incomplete_model.h"

#include <memory>
#include <vector>

namespace pcl::repair {

/** \brief A radius search that misses nothing: positions go into the tree in a frame in
 * which they fill a unit box, and the radius has room for what floats are wrong by.
 * Const methods may be called from several threads. */
class FloatTree {
public:
  FloatTree() = default;

  /** \param[in] search gets the positions as its input; null: search::KdTree */
  explicit FloatTree(const Positions& positions,
                     pcl::search::Search<pcl::PointXYZ>::Ptr search = nullptr);

  /** \brief All positions within a radius, and perhaps a few more, ascending. */
  void
  near(const Position& center, double radius, std::vector<pcl::index_t>& found) const;

  /** \brief The nearest positions, as many or all, nearest first, the lower number
   * among equals; as near as floats tell. */
  std::vector<pcl::index_t>
  nearest(const Position& center, std::size_t number) const;

private:
  Position
  toFrame(const Position& position) const
  {
    return (position - origin_) * scale_;
  }

  Position origin_ = Position::Zero();
  double scale_ = 1.0;
  pcl::search::Search<pcl::PointXYZ>::Ptr tree_; /**< none: no position */
  pcl::index_t size_ = 0;
};

} // namespace pcl::repair
