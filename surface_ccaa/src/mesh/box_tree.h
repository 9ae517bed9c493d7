// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes meet a given box or segment.
#pragma once

#include <Eigen/Geometry>

#include "mesh/block_loop.h"
#include "mesh/corners.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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

  /** \brief Call visit(index) for each box that meets the query (touching counts). */
  template <typename Visit>
  void
  forEachMeeting(const Box& query, const Visit& visit) const
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
  template <typename Visit>
  void
  forEachMeeting(const Corners& triangle, const Visit& visit) const
  {
    anyMeeting(triangle, [&](pcl::index_t index) {
      visit(index);
      return false;
    });
  }
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
  static constexpr std::size_t FAN_OUT = 8;
  /** Floats that a register of any processor holds. */
  static constexpr std::size_t WIDTH = 4;
  /** By how much squared distances in the frame may be too large. */
  static constexpr double ROUNDING = 1.0 + 1e-6;
  static constexpr float NOWHERE = std::numeric_limits<float>::infinity();

  struct FloatBox {
    std::array<float, 3> low = {NOWHERE, NOWHERE, NOWHERE};
    std::array<float, 3> high = {-NOWHERE, -NOWHERE, -NOWHERE};
  };

  /** A segment: from + t / inverse, t in [0, 1]. All of it as often as boxes are looked
   * at in one go. */
  struct alignas(16) Ray {
    float from[3][WIDTH], inverse[3][WIDTH];
    std::size_t entry[3]; /**< which bound of a box it passes first: 0 low, 1 high */
  };

  /** A triangle: its box, and how far it reaches along its normal. */
  struct Slab {
    FloatBox box;
    std::array<float, 3> normal = {0.0f, 0.0f, 0.0f};
    float low = 0.0f, high = 0.0f;
    std::array<std::size_t, 3> lower; /**< which bound of a box is: 0 low, 1 high */
  };

  /** The bounds of eight boxes; those that are missing are inside out. */
  struct alignas(32) Node {
    float bounds[2][3][FAN_OUT]; /**< low and high */

    void
    set(std::size_t child, const FloatBox& box);
    FloatBox
    around() const;
    /** A bit for each box that meets the query. */
    unsigned int
    meeting(const FloatBox& query) const;
    unsigned int
    meeting(const Ray& ray) const;
    unsigned int
    meeting(const Slab& slab) const;
    /** Squared distances from the query. */
    std::array<float, FAN_OUT>
    distances(const FloatBox& query) const;
  };

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

inline void
BoxTree::Node::set(std::size_t child, const FloatBox& box)
{
  for (std::size_t k = 0; k < 3; ++k) {
    bounds[0][k][child] = box.low[k];
    bounds[1][k][child] = box.high[k];
  }
}

inline unsigned int
BoxTree::Node::meeting(const FloatBox& query) const
{
  unsigned int met = 0;
  for (std::size_t first = 0; first < FAN_OUT; first += WIDTH) {
#ifdef __SSE2__ // of every x86-64, and much faster than what compilers make
    __m128 apart = _mm_setzero_ps();
    for (std::size_t k = 0; k < 3; ++k) {
      const __m128 low = _mm_load_ps(bounds[0][k] + first);
      const __m128 high = _mm_load_ps(bounds[1][k] + first);
      apart = _mm_or_ps(apart, _mm_cmpgt_ps(low, _mm_set1_ps(query.high[k])));
      apart = _mm_or_ps(apart, _mm_cmplt_ps(high, _mm_set1_ps(query.low[k])));
    }
    met |= (~static_cast<unsigned int>(_mm_movemask_ps(apart)) & 0xfu) << first;
#else
    for (std::size_t i = first; i < first + WIDTH; ++i) {
      bool meets = true;
      for (std::size_t k = 0; k < 3; ++k)
        meets = meets && bounds[0][k][i] <= query.high[k] &&
                bounds[1][k][i] >= query.low[k];
      met |= static_cast<unsigned int>(meets) << i;
    }
#endif
  }
  return met;
}

/** Where the pairs of planes are passed: a box is met if there is a t inside all three
 * pairs and inside [0, 1]. The boxes' margin covers the rounding. */
inline unsigned int
BoxTree::Node::meeting(const Ray& ray) const
{
  unsigned int met = 0;
  for (std::size_t first = 0; first < FAN_OUT; first += WIDTH) {
#ifdef __SSE2__
    __m128 enter = _mm_setzero_ps(), leave = _mm_set1_ps(1.0f);
    for (std::size_t k = 0; k < 3; ++k) {
      const __m128 from = _mm_load_ps(ray.from[k]);
      const __m128 inverse = _mm_load_ps(ray.inverse[k]);
      const __m128 near = _mm_load_ps(bounds[ray.entry[k]][k] + first);
      const __m128 far = _mm_load_ps(bounds[1 - ray.entry[k]][k] + first);
      enter = _mm_max_ps(enter, _mm_mul_ps(_mm_sub_ps(near, from), inverse));
      leave = _mm_min_ps(leave, _mm_mul_ps(_mm_sub_ps(far, from), inverse));
    }
    const int hits = _mm_movemask_ps(_mm_cmple_ps(enter, leave));
    met |= static_cast<unsigned int>(hits) << first;
#else
    for (std::size_t i = 0; i < WIDTH; ++i) {
      float enter = 0.0f, leave = 1.0f;
      for (std::size_t k = 0; k < 3; ++k) {
        const float near = bounds[ray.entry[k]][k][first + i];
        const float far = bounds[1 - ray.entry[k]][k][first + i];
        enter = std::max(enter, (near - ray.from[k][i]) * ray.inverse[k][i]);
        leave = std::min(leave, (far - ray.from[k][i]) * ray.inverse[k][i]);
      }
      met |= static_cast<unsigned int>(enter <= leave) << (first + i);
    }
#endif
  }
  return met;
}

/** The boxes' margin covers the rounding. */
inline unsigned int
BoxTree::Node::meeting(const Slab& slab) const
{
  unsigned int met = meeting(slab.box);
  for (std::size_t first = 0; first < FAN_OUT && met >> first != 0; first += WIDTH) {
#ifdef __SSE2__
    __m128 least = _mm_setzero_ps(), most = _mm_setzero_ps();
    for (std::size_t k = 0; k < 3; ++k) {
      const __m128 normal = _mm_set1_ps(slab.normal[k]);
      const __m128 lower = _mm_load_ps(bounds[slab.lower[k]][k] + first);
      const __m128 upper = _mm_load_ps(bounds[1 - slab.lower[k]][k] + first);
      least = _mm_add_ps(least, _mm_mul_ps(lower, normal));
      most = _mm_add_ps(most, _mm_mul_ps(upper, normal));
    }
    const __m128 apart = _mm_or_ps(_mm_cmpgt_ps(least, _mm_set1_ps(slab.high)),
                                   _mm_cmplt_ps(most, _mm_set1_ps(slab.low)));
    met &= ~(static_cast<unsigned int>(_mm_movemask_ps(apart)) << first);
#else
    for (std::size_t i = first; i < first + WIDTH; ++i) {
      float least = 0.0f, most = 0.0f;
      for (std::size_t k = 0; k < 3; ++k) {
        least += slab.normal[k] * bounds[slab.lower[k]][k][i];
        most += slab.normal[k] * bounds[1 - slab.lower[k]][k][i];
      }
      if (least > slab.high || most < slab.low)
        met &= ~(1u << i);
    }
#endif
  }
  return met;
}

} // namespace pcl::ccaa
