// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: eight boxes side by side, as a BoxTree keeps them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl::ccaa::box_node {

/** Boxes of a node. */
constexpr std::size_t FAN_OUT = 8;
/** Floats that a register of any processor holds. */
constexpr std::size_t WIDTH = 4;
constexpr float NOWHERE = std::numeric_limits<float>::infinity();

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

inline void
Node::set(std::size_t child, const FloatBox& box)
{
  for (std::size_t k = 0; k < 3; ++k) {
    bounds[0][k][child] = box.low[k];
    bounds[1][k][child] = box.high[k];
  }
}

inline unsigned int
Node::meeting(const FloatBox& query) const
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
Node::meeting(const Ray& ray) const
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
Node::meeting(const Slab& slab) const
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

inline FloatBox
Node::around() const
{
  FloatBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = *std::min_element(bounds[0][k], bounds[0][k] + FAN_OUT);
    box.high[k] = *std::max_element(bounds[1][k], bounds[1][k] + FAN_OUT);
  }
  return box;
}

inline std::array<float, FAN_OUT>
Node::distances(const FloatBox& query) const
{
  std::array<float, FAN_OUT> squared;
  squared.fill(0.0f);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < FAN_OUT; ++i) {
      const float below = bounds[0][k][i] - query.high[k];
      const float above = query.low[k] - bounds[1][k][i];
      const float apart = std::max(std::max(below, above), 0.0f);
      squared[i] += apart * apart;
    }
  return squared;
}

} // namespace pcl::ccaa::box_node
