// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the sources in flat arrays, and which are near a place.
#pragma once

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include "field/field_kernel.h"
#include "field/field_source.h"
#include "field/float_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief A ball. */
struct Ball {
  Position center = Position::Zero();
  double radius = 0.0;
};

/** \brief Sources in blocks of eight neighbours of a curve, and a PCL KdTree over the
 * balls around groups of eight blocks.
 *
 * Seen from afar a block counts as one coarse source, so that a group is one more
 * block, of coarse sources: the stretch of boundary it stands for sampled more widely.
 * That changes the sum by the square of block radius by distance, where nothing else
 * changes within a block: in light mode without effective charges.
 *
 * All in a frame of its own, in which the sources fill a unit box around the origin:
 * the kernel uses single precision in between, and models may be of any size. Const
 * methods may be called from several threads.
 */
class SourceBlocks {
public:
  /** \brief Rows of a block as the kernel reads them. */
  struct alignas(64) Rows {
    double values[field_kernel::ROWS][field_kernel::LANES];
  };

  /** \brief The blocks of one curve. */
  struct Range {
    std::uint32_t begin = 0, end = 0;
  };

  /** \brief Consecutive blocks of a curve. */
  struct Group {
    Range blocks;
    Ball ball;
    std::uint32_t coarse = 0; /**< the block of their coarse sources */
    double coarse_from = 0.0; /**< distance of the ball's centre from which these do */
  };

  /** \param[in] coarse_distance radii of a block from which it is a coarse source; 0:
   * none is */
  SourceBlocks(const SourceSet& sources, double coarse_distance);

  /** \brief From 1 on, of no other blocks of this run of the program. */
  std::uint64_t
  number() const
  {
    return number_;
  }

  Position
  toFrame(const Position& position) const
  {
    return (position - origin_) * scale_;
  }

  /** \brief Of the source in a lane of a block, in the cloud. */
  const Position&
  position(std::size_t block, std::size_t lane) const
  {
    return positions_[block * field_kernel::LANES + lane];
  }

  /** \brief Length in the frame by length in the cloud. */
  double
  scale() const
  {
    return scale_;
  }

  const double*
  rows() const
  {
    return &rows_.front().values[0][0];
  }

  const Ball&
  ball(std::size_t block) const
  {
    return balls_[block];
  }

  std::size_t
  island(std::size_t block) const
  {
    return islands_[curve_of_[block]];
  }

  std::size_t
  curveOf(std::size_t block) const
  {
    return curve_of_[block];
  }

  std::size_t
  curveCount() const
  {
    return curves_.size();
  }

  const Group&
  group(std::size_t number) const
  {
    return groups_[number];
  }

  /** \brief Groups that may have sources within a ball (in the frame), ascending. */
  void
  near(const Ball& place, std::vector<std::uint32_t>& groups) const;

private:
  void
  placeFrame(const SourceSet& sources);
  void
  append(const SourceCurve& curve);
  void
  groupBlocks(Range curve);
  void
  addCoarse(const SourceCurve& curve, double distance, Group& group);
  void
  buildTree();

  std::uint64_t number_;
  Position origin_ = Position::Zero();
  double scale_ = 1.0;
  std::vector<Rows> rows_; /**< of all blocks, and then of all coarse ones */
  Positions positions_;    /**< LANES for each block */
  std::vector<Ball> balls_;
  std::vector<std::size_t> curve_of_; /**< of a block */
  std::vector<std::size_t> islands_;  /**< of a curve */
  std::vector<Range> curves_;
  std::vector<Group> groups_;
  double largest_group_ = 0.0;
  FloatTree tree_; /**< of the groups' centres */
};

} // namespace pcl::repair
