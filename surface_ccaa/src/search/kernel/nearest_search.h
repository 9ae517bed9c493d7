// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the k nearest neighbors of eight queries at once.
#pragma once

#include "search/kernel/candidate_rows.h"
#include "search/kernel/window_bound.h"

namespace pcl::ccaa::block_kernel::PCL_KERNEL {

constexpr std::uint32_t NO_BLOCK = ~std::uint32_t(0);
/** A query whose bound is so many times the median of its block walks alone. */
constexpr float FAR_FACTOR = 16.f;

/** Nearest neighbors of up to eight places that are close to each other. */
class NearestSearch {
public:
  NearestSearch(const BlockView& view, const Scratch& scratch, unsigned int k)
  : view_(view), scratch_(scratch), k_(k), rows_(scratch, k)
  {
    for (unsigned int lane = 0; lane < LANES; ++lane)
      bounds_[lane] = INFINITE;
  }

  /** Queries are the points of a block; none of them is its own neighbor. Returns the
   * mask of those that exist. */
  unsigned int
  searchBlock(std::uint32_t block)
  {
    own_block_ = block;
    const float* points = view_.coordinates + std::size_t(block) * BLOCK_FLOATS;
    for (unsigned int lane = 0; lane < LANES; ++lane)
      queries_.set(lane, points[lane], points[lane + LANES], points[lane + 2 * LANES]);
    const unsigned int lanes = lessEqual(load(queries_.x), load(queries_.x));
    WindowBound(view_, scratch_, block, k_ + 1).tighten(queries_, lanes, bounds_);
    const unsigned int far = farLanes(lanes);
    collect(lanes & ~far);
    for (unsigned int rest = far; rest != 0; rest &= rest - 1)
      searchAlone(static_cast<unsigned int>(__builtin_ctz(rest)));
    return lanes;
  }

  void
  searchPlace(const float* query, float max_sqr_distance)
  {
    for (unsigned int lane = 0; lane < LANES; ++lane)
      queries_.set(lane, query[0], query[1], query[2]);
    bounds_[0] = max_sqr_distance;
    searchNearestFirst(0, k_);
  }

  /** Sort what a query has found; its k nearest are then in scratch. Returns how many
   * there are. */
  unsigned int
  sortRow(unsigned int lane)
  {
    return rows_.sort(lane);
  }

private:
  /** Queries whose bound is so large that the others should not walk with them. */
  unsigned int
  farLanes(unsigned int lanes) const
  {
    float sorted[LANES];
    unsigned int size = 0;
    for (unsigned int rest = lanes; rest != 0; rest &= rest - 1, ++size) {
      const float bound = bounds_[__builtin_ctz(rest)];
      unsigned int i = size;
      for (; i > 0 && sorted[i - 1] > bound; --i)
        sorted[i] = sorted[i - 1];
      sorted[i] = bound;
    }
    const float limit = sorted[(size - 1) / 2] * FAR_FACTOR;
    return lanes & ~lessEqual(load(bounds_), all(limit));
  }

  /** Fill the row of one query from the nearest boxes on, which copes with any bound.
   * Of points equally far as the k-th, any may be in the row. */
  void
  searchNearestFirst(unsigned int lane, unsigned int needed)
  {
    active_ = 1u << lane;
    WindowBound(view_, scratch_, blockNear(lane), needed)
        .tightenOne(queries_, lane, bounds_);
    descend(view_.top, 0, lane);
  }

  /** Search a query once more in the order of ranks, with the best bound there is. */
  void
  searchAlone(unsigned int lane)
  {
    searchNearestFirst(lane, k_ + 1);
    if (sortRow(lane) == k_)
      bounds_[lane] = scratch_.sorted_distances[k_ - 1];
    rows_.clear(lane);
    collect(1u << lane);
  }

  /** Down the tree, always into the nearest box; of boxes around the query, which
   * overlap, the one whose middle is nearest. A guess, good enough for a bound. */
  std::uint32_t
  blockNear(unsigned int lane) const
  {
    std::uint32_t group = 0;
    for (unsigned int level = view_.top + 1; level-- > 0;) {
      const float* boxes = view_.boxes[level] + std::size_t(group) * GROUP_FLOATS;
      const Floats gaps = sqrGaps(boxes, queries_, lane);
      alignas(32) float keys[LANES];
      store(keys, gaps + all(0.05f) * sqrOffsets(boxes, queries_, lane));
      group = group * LANES + smallest(keys, lessEqual(gaps, all(INFINITE)));
    }
    return group;
  }

  void
  descend(unsigned int level, std::uint32_t group, unsigned int lane)
  {
    const Floats sqr_gaps =
        sqrGaps(view_.boxes[level] + std::size_t(group) * GROUP_FLOATS, queries_, lane);
    alignas(32) float gaps[LANES];
    store(gaps, sqr_gaps);
    unsigned int rest = lessEqual(sqr_gaps, all(bounds_[lane]));
    while (rest != 0) {
      const unsigned int next = smallest(gaps, rest);
      rest &= ~(1u << next);
      if (!(gaps[next] <= bounds_[lane]))
        return;
      if (level == 0)
        take(group * LANES + next, 1u << lane);
      else
        descend(level - 1, group * LANES + next, lane);
    }
  }

  /** Gather, for each of these queries, the points within its bound. */
  void
  collect(unsigned int lanes)
  {
    active_ = lanes;
    queries_.bound(lanes);
    updateReach();
    walk(view_.top, 0);
  }

  void
  updateReach()
  {
    reach_ = -1.f;
    for (unsigned int rest = active_; rest != 0; rest &= rest - 1) {
      const float bound = bounds_[__builtin_ctz(rest)];
      reach_ = bound > reach_ ? bound : reach_;
    }
  }

  /** Always in the order of the ranks: see CandidateRows::narrow(). */
  void
  walk(unsigned int level, std::uint32_t group)
  {
    const float* boxes = view_.boxes[level] + std::size_t(group) * GROUP_FLOATS;
    unsigned int rest = boxesInReach(boxes, queries_, reach_);
    for (; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<unsigned int>(__builtin_ctz(rest));
      const std::uint32_t child = group * LANES + lane;
      if (level == 0)
        visit(child, boxes + lane);
      else
        walk(level - 1, child);
    }
  }

  void
  visit(std::uint32_t block, const float* box)
  {
    const auto gapAlong = [box](const float* places, unsigned int axis) {
      const Floats place = load(places);
      return gap(place, place, all(box[axis * LANES]), all(box[(axis + 3) * LANES]));
    };
    const Floats gaps = sqrLength(
        gapAlong(queries_.x, 0), gapAlong(queries_.y, 1), gapAlong(queries_.z, 2));
    take(block, lessEqual(gaps, load(bounds_)) & active_);
  }

  /** Append the points of a block to the rows of these queries, where they are within
   * the bound. */
  void
  take(std::uint32_t block, unsigned int lanes)
  {
    const float* points = view_.coordinates + std::size_t(block) * BLOCK_FLOATS;
    const Floats x = load(points);
    const Floats y = load(points + LANES);
    const Floats z = load(points + 2 * LANES);
    const unsigned int own = block == own_block_ ? 1 : 0;
    for (unsigned int rest = lanes; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<unsigned int>(__builtin_ctz(rest));
      const Floats distances = sqrLength(x - all(queries_.x[lane]),
                                         y - all(queries_.y[lane]),
                                         z - all(queries_.z[lane]));
      const unsigned int mask = lessEqual(distances, all(bounds_[lane]));
      if (rows_.append(lane, block, distances, mask & ~(own << lane))) {
        bounds_[lane] = rows_.narrow(lane);
        updateReach();
      }
    }
  }

  const BlockView& view_;
  const Scratch& scratch_;
  unsigned int k_;
  CandidateRows rows_;
  std::uint32_t own_block_ = NO_BLOCK;
  Queries queries_;
  alignas(32) float bounds_[LANES];
  /** The queries that walk, and the largest of their bounds. */
  unsigned int active_ = 0;
  float reach_ = -1.f;
};

} // namespace pcl::ccaa::block_kernel::PCL_KERNEL
