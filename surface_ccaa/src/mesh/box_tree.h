// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box.
#pragma once

#include <Eigen/Geometry>

#include "mesh/corners.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {
namespace ccaa {

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

/** \brief A static tree over boxes: sorted along a space-filling curve, eight
 * neighbours to a node, nodes in flat arrays level by level.
 *
 * Deterministic: the same boxes give the same tree. Cost: building about 0.2 us a box,
 * a query for a small box about 0.5 us; about 70 bytes a box. Const methods may be
 * called from several threads.
 */
class BoxTree {
public:
  BoxTree() = default;

  /** \brief Build from boxes; empty boxes are left out and never found. */
  explicit BoxTree(const std::vector<Box>& boxes);

  /** \brief Number of boxes that can be found. */
  std::size_t
  size() const
  {
    return items_.size();
  }

  /** \brief The boxes' indices in the order of the tree, neighbours close together. */
  const std::vector<pcl::index_t>&
  order() const
  {
    return items_;
  }

  /** \brief Call visit(index) for each box that meets the query (touching counts). */
  template <typename Visit>
  void
  forEachMeeting(const Box& query, const Visit& visit) const
  {
    if (!levels_.empty())
      descend(levels_.size() - 1, 0, query, visit);
  }

  /** \brief Whether test(index) holds for a box that meets the query; the others are
   * not asked any more. */
  template <typename Test>
  bool
  anyMeeting(const Box& query, const Test& test) const
  {
    return !levels_.empty() && search(levels_.size() - 1, 0, query, test);
  }

  /** \brief Call visit(index) for boxes that are no further from the query than a
   * squared distance, the near ones first; what visit returns holds from then on. Some
   * that are further by rounding are visited, too. */
  template <typename Visit>
  void
  forEachNear(const Box& query, double squared, const Visit& visit) const
  {
    squared *= ROUNDING;
    if (!levels_.empty())
      approach(levels_.size() - 1, 0, query, squared, visit);
  }

private:
  static constexpr std::size_t FAN_OUT = 8;
  static constexpr double ROUNDING = 1.0 + 1e-9;

  template <typename Visit>
  void
  approach(std::size_t level,
           std::size_t node,
           const Box& query,
           double& squared,
           const Visit& visit) const
  {
    const std::size_t begin = node * FAN_OUT;
    const std::size_t end = std::min(begin + FAN_OUT, levels_[level].size());
    std::array<std::pair<double, std::size_t>, FAN_OUT> children;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double distance = levels_[level][i].squaredExteriorDistance(query);
      if (!(distance <= squared))
        continue;
      std::size_t place = count++;
      for (; place > 0 && children[place - 1].first > distance; --place)
        children[place] = children[place - 1];
      children[place] = {distance, i};
    }
    for (std::size_t k = 0; k < count && children[k].first <= squared; ++k)
      if (level == 0)
        squared = ROUNDING * visit(items_[children[k].second]);
      else
        approach(level - 1, children[k].second, query, squared, visit);
  }

  template <typename Test>
  bool
  search(std::size_t level, std::size_t node, const Box& query, const Test& test) const
  {
    const std::size_t begin = node * FAN_OUT;
    const std::size_t end = std::min(begin + FAN_OUT, levels_[level].size());
    for (std::size_t i = begin; i < end; ++i)
      if (levels_[level][i].intersects(query) &&
          (level == 0 ? test(items_[i]) : search(level - 1, i, query, test)))
        return true;
    return false;
  }

  template <typename Visit>
  void
  descend(std::size_t level,
          std::size_t node,
          const Box& query,
          const Visit& visit) const
  {
    const std::size_t begin = node * FAN_OUT;
    const std::size_t end = std::min(begin + FAN_OUT, levels_[level].size());
    for (std::size_t i = begin; i < end; ++i) {
      if (!levels_[level][i].intersects(query))
        continue;
      if (level == 0)
        visit(items_[i]);
      else
        descend(level - 1, i, query, visit);
    }
  }

  std::vector<pcl::index_t> items_;
  std::vector<std::vector<Box>> levels_; /**< level 0: the boxes; each next one 1/8 */
};

} // namespace ccaa
} // namespace pcl
