// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which of many boxes a segment passes.
#pragma once

#include "mesh/box_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl {
namespace repair {

/** \brief A static tree over boxes for segments: eight neighbours to a node, whose
 * bounds lie side by side so that one pass over them answers for all eight. Boxes are
 * kept in single precision, rounded outwards: a box that the segment meets is never
 * missed. Const methods may be called from several threads. */
class SegmentTree {
public:
  SegmentTree() = default;
  /** \brief Empty boxes are left out. The same tree for any number of threads. */
  explicit SegmentTree(const std::vector<ccaa::Box>& boxes, int threads = 1);

  /** \brief The boxes' indices by place in the tree. */
  const std::vector<pcl::index_t>&
  order() const
  {
    return order_;
  }

  /** \brief Whether test(place) is true for any box the segment meets; stops there. */
  template <typename Test>
  bool
  any(const ccaa::Position& a, const ccaa::Position& b, const Test& test) const
  {
    if (levels_.empty())
      return false;
    const Ray ray = rayFrom(a, b);
    std::array<std::uint64_t, STACK> stack; // level and node
    std::size_t height = 0;
    stack[height++] = (levels_.size() - 1) << 32;
    while (height > 0) {
      const std::uint64_t level = stack[--height] >> 32;
      const std::uint64_t node = stack[height] & 0xffffffffu;
      unsigned int hits = levels_[level][node].meets(ray);
      for (; hits != 0; hits &= hits - 1) {
        const std::uint64_t child =
            node * FAN_OUT + static_cast<unsigned int>(__builtin_ctz(hits));
        if (level > 0)
          stack[height++] = (level - 1) << 32 | child;
        else if (test(static_cast<std::size_t>(child)))
          return true;
      }
    }
    return false;
  }

private:
  static constexpr std::size_t FAN_OUT = 8;
  /** \brief Room for a path of 22 levels, seven brothers waiting at each. */
  static constexpr std::size_t STACK = 160;

  /** \brief Floats a register of any processor holds. */
  static constexpr std::size_t WIDTH = 4;

  /** \brief A segment in the frame of the tree: from + t / inverse, t in [0, 1]. All of
   * it as often as boxes are looked at in one go. */
  struct alignas(16) Ray {
    float from[3][WIDTH], inverse[3][WIDTH];
    std::size_t entry[3]; /**< which bound of a box it passes first: 0 low, 1 high */
  };

  /** \brief The bounds of eight children. */
  struct alignas(32) Node {
    float bounds[2][3][FAN_OUT]; /**< low and high */

    /** \brief A bit for each child whose box the segment meets. */
    unsigned int
    meets(const Ray& ray) const;
    void
    set(std::size_t child, const ccaa::Box& box);
    ccaa::Box
    box() const;
  };

  /** \brief Put boxes (in the frame) into nodes of a new level. \return the nodes' */
  std::vector<ccaa::Box>
  addLevel(const std::vector<ccaa::Box>& lower);

  Ray
  rayFrom(const ccaa::Position& a, const ccaa::Position& b) const;

  ccaa::Position origin_ = ccaa::Position::Zero();
  double scale_ = 1.0; /**< to the frame, in which all is within a unit box */
  std::vector<pcl::index_t> order_;
  std::vector<std::vector<Node>> levels_; /**< level 0: the boxes; each next one 1/8 */
};

/** Where the eight pairs of planes are passed: a box is met if there is a t inside all
 * three pairs and inside [0, 1]. The boxes' margin covers the rounding. */
inline unsigned int
SegmentTree::Node::meets(const Ray& ray) const
{
  unsigned int hits = 0;
  for (std::size_t first = 0; first < FAN_OUT; first += WIDTH) {
#ifdef __SSE2__ // of every x86-64, and three times as fast as what compilers make
    __m128 enter = _mm_setzero_ps(), leave = _mm_set1_ps(1.0f);
    for (std::size_t k = 0; k < 3; ++k) {
      const __m128 from = _mm_load_ps(ray.from[k]);
      const __m128 inverse = _mm_load_ps(ray.inverse[k]);
      const __m128 near = _mm_load_ps(bounds[ray.entry[k]][k] + first);
      const __m128 far = _mm_load_ps(bounds[1 - ray.entry[k]][k] + first);
      enter = _mm_max_ps(enter, _mm_mul_ps(_mm_sub_ps(near, from), inverse));
      leave = _mm_min_ps(leave, _mm_mul_ps(_mm_sub_ps(far, from), inverse));
    }
    const int met = _mm_movemask_ps(_mm_cmple_ps(enter, leave));
    hits |= static_cast<unsigned int>(met) << first;
#else
    for (std::size_t i = 0; i < WIDTH; ++i) {
      float enter = 0.0f, leave = 1.0f;
      for (std::size_t k = 0; k < 3; ++k) {
        const float near = bounds[ray.entry[k]][k][first + i];
        const float far = bounds[1 - ray.entry[k]][k][first + i];
        enter = std::max(enter, (near - ray.from[k][i]) * ray.inverse[k][i]);
        leave = std::min(leave, (far - ray.from[k][i]) * ray.inverse[k][i]);
      }
      hits |= static_cast<unsigned int>(enter <= leave) << (first + i);
    }
#endif
  }
  return hits;
}

} // namespace repair
} // namespace pcl
