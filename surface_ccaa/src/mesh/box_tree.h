// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box or segment.
#pragma once

#include <Eigen/Geometry>

#include "mesh/block_loop.h"
#include "mesh/box_node.h"
#include "mesh/corners.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::ccaa {

using Box = Eigen::AlignedBox3d;

/** \brief The smallest box around a triangle. */
inline Box
boxOf(const Corners& corners)
{
  return {corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
          corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
}

/** \brief A box with so much room on every side. */
inline Box
widened(const Box& box, double room)
{
  const Position all_around = Position::Constant(room);
  return {box.min() - all_around, box.max() + all_around};
}

/** \brief The boxes that are not empty, in an order in which those that follow each
 * other are close in space: their middles along a Hilbert curve (curveOrder()). The
 * same for any number of threads. Linear for ordinary meshes. \param[in,out] control
 * told the work, may be null */
std::vector<pcl::index_t>
neighboringOrder(const std::vector<Box>& boxes,
                 int threads = 1,
                 RunControl* control = nullptr);

/** \brief A static tree over boxes in single precision, in a frame in which they fill a
 * unit box: eight to a node, whose bounds lie side by side so that one pass over them
 * answers for all eight, nodes in flat arrays level by level.
 *
 * Boxes are a little too large, so that none that meets a query is missed; some are
 * visited that miss it by a rounding. Empty boxes are never visited. The same boxes
 * give the same tree, whatever the number of threads. Cost: building about 0.03 us a
 * box and the order, a query for a small box about 0.1 us; 28 bytes a box. Const
 * methods may be called from several threads. */
class BoxTree {
public:
  BoxTree() = default;

  /** \brief Build from boxes in neighboringOrder(). */
  explicit BoxTree(const std::vector<Box>& boxes,
                   int threads = 1,
                   RunControl* control = nullptr);

  /** \brief Build from the boxes boxOf(0), ..., boxOf(count - 1) in their order. */
  template <typename BoxOf>
  BoxTree(std::size_t count, const LoopContext& context, const BoxOf& boxOf)
  {
    build(count, context, boxOf);
  }

  /** \brief The boxes' indices by place in the tree; none where they are in their
   * order. */
  const std::vector<pcl::index_t>&
  order() const
  {
    return order_;
  }

  /** \brief Call visit(index) for each box that meets the query, a box or a triangle
   * (touching counts). */
  template <typename Query, typename Visit>
  void
  forEachMeeting(const Query& query, const Visit& visit) const
  {
    anyMeeting(query, [&](pcl::index_t index) {
      visit(index);
      return false;
    });
  }

  /** \brief Whether test(index) holds for a box that meets the query; the others are
   * not asked any more. */
  template <typename Test>
  bool
  anyMeeting(const Box& query, const Test& test) const
  {
    return !levels_.empty() && !query.isEmpty() &&
           descend(levels_.size() - 1, 0, toFrame(query), test);
  }

  /** \brief The same for a triangle: boxes that meet its box and its plane. Of those
   * that meet the box of one that lies askew these are few. */
  template <typename Test>
  bool
  anyMeeting(const Corners& triangle, const Test& test) const
  {
    return !levels_.empty() && descend(levels_.size() - 1, 0, slabOf(triangle), test);
  }

  /** \brief The same for boxes that the segment from a to b passes. */
  template <typename Test>
  bool
  anyAlong(const Position& a, const Position& b, const Test& test) const
  {
    return !levels_.empty() && descend(levels_.size() - 1, 0, rayFrom(a, b), test);
  }

  /** \brief Call visit(index) for boxes that are no further from the query than a
   * squared distance, the near ones first; what visit returns holds from then on. */
  template <typename Visit>
  void
  forEachNear(const Box& query, double squared, const Visit& visit) const
  {
    if (!levels_.empty())
      approach(levels_.size() - 1, 0, toFrame(query), squared, visit);
  }

private:
  /** By how much squared distances in the frame may be too large. */
  static constexpr double ROUNDING = 1.0 + 1e-6;
  static constexpr std::size_t FAN_OUT = box_node::FAN_OUT;

  using FloatBox = box_node::FloatBox;
  using Ray = box_node::Ray;
  using Slab = box_node::Slab;
  using Node = box_node::Node;
  using Level = std::vector<Node>;

  void
  setFrame(const Box& bounds);
  /** A query. */
  FloatBox
  toFrame(const Box& box) const;
  /** A box to be stored; one that is empty stays so. */
  FloatBox
  enlarged(const Box& box) const;
  Ray
  rayFrom(const Position& a, const Position& b) const;
  Slab
  slabOf(const Corners& triangle) const;

  /** Up to where boxes are no further than a squared distance. */
  float
  reachOf(double squared) const
  {
    constexpr double MOST = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(squared * scale_ * scale_ * ROUNDING, MOST));
  }

  pcl::index_t
  indexAt(std::size_t place) const
  {
    return order_.empty() ? static_cast<pcl::index_t>(place) : order_[place];
  }

  template <typename BoxOf>
  void
  build(std::size_t count, const LoopContext& context, const BoxOf& boxOf)
  {
    Box bounds;
    for (std::size_t i = 0; i < count; ++i)
      bounds.extend(boxOf(i));
    if (bounds.isEmpty())
      return;
    setFrame(bounds);
    addLevel(count, context, [&](std::size_t i) { return enlarged(boxOf(i)); });
    while (levels_.back().size() > 1) {
      const std::size_t lower = levels_.size() - 1;
      addLevel(levels_.back().size(), context, [&](std::size_t i) {
        return levels_[lower][i].around();
      });
    }
  }

  template <typename FloatBoxOf>
  void
  addLevel(std::size_t count, const LoopContext& context, const FloatBoxOf& boxOf)
  {
    Level level((count + FAN_OUT - 1) / FAN_OUT);
    const auto fill = [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * FAN_OUT; i < end * FAN_OUT; ++i)
        level[i / FAN_OUT].set(i % FAN_OUT, i < count ? boxOf(i) : FloatBox());
    };
    forEachBlock(level.size(), context, fill);
    levels_.push_back(std::move(level));
  }

  template <typename Query, typename Test>
  bool
  descend(std::size_t level,
          std::size_t node,
          const Query& query,
          const Test& test) const
  {
    unsigned int met = levels_[level][node].meeting(query);
    for (; met != 0; met &= met - 1) {
      const std::size_t child =
          node * FAN_OUT + static_cast<unsigned int>(__builtin_ctz(met));
      if (level == 0 ? test(indexAt(child)) : descend(level - 1, child, query, test))
        return true;
    }
    return false;
  }

  template <typename Visit>
  void
  approach(std::size_t level,
           std::size_t node,
           const FloatBox& query,
           double& squared,
           const Visit& visit) const
  {
    const std::array<float, FAN_OUT> distances = levels_[level][node].distances(query);
    std::array<std::pair<float, std::size_t>, FAN_OUT> children;
    std::size_t count = 0;
    for (std::size_t i = 0; i < FAN_OUT; ++i) {
      const float distance = distances[i];
      if (!(distance <= reachOf(squared)))
        continue;
      std::size_t place = count++;
      for (; place > 0 && children[place - 1].first > distance; --place)
        children[place] = children[place - 1];
      children[place] = {distance, node * FAN_OUT + i};
    }
    for (std::size_t k = 0; k < count && children[k].first <= reachOf(squared); ++k)
      if (level == 0)
        squared = visit(indexAt(children[k].second));
      else
        approach(level - 1, children[k].second, query, squared, visit);
  }

  Position origin_ = Position::Zero();
  double scale_ = 1.0; /**< to the frame */
  std::vector<pcl::index_t> order_;
  std::vector<Level> levels_; /**< level 0: the boxes; each next one 1/8 */
};

} // namespace pcl::ccaa
