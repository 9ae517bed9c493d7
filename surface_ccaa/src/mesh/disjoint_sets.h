// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: union-find, which several threads may fill at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Sets of the numbers [0, count), without locks.
 *
 * A root is always the lowest number of its set, so the final sets and roots do not
 * depend on who joined what first. Parents only ever move towards the root, which is
 * why relaxed order is enough: a stale parent is a longer way, not a wrong one. */
class DisjointSets {
public:
  /** \brief Whether each number is a set of its own from the start, or is to be made
   * one by makeSet() first, which threads can share. */
  enum class Begin { SINGLE, EMPTY };

  explicit DisjointSets(std::size_t count, Begin begin = Begin::SINGLE)
  : parents_(count)
  {
    for (std::size_t i = 0; begin == Begin::SINGLE && i < count; ++i)
      makeSet(i);
  }

  void
  makeSet(std::size_t number)
  {
    parents_[number].store(static_cast<std::uint32_t>(number),
                           std::memory_order_relaxed);
  }

  /** \brief Root of the set of a number; halves the way on its way. */
  std::size_t
  find(std::size_t number)
  {
    std::size_t parent = load(number);
    while (parent != number) {
      const std::size_t grandparent = load(parent);
      if (grandparent == parent)
        return parent;
      parents_[number].store(static_cast<std::uint32_t>(grandparent),
                             std::memory_order_relaxed);
      number = grandparent;
      parent = load(number);
    }
    return number;
  }

  void
  join(std::size_t a, std::size_t b)
  {
    if (load(a) == load(b)) // mostly so: both are next to the root already
      return;
    for (;;) {
      a = find(a);
      b = find(b);
      if (a == b)
        return;
      if (a < b)
        std::swap(a, b);
      auto expected = static_cast<std::uint32_t>(a);
      if (parents_[a].compare_exchange_strong(
              expected, static_cast<std::uint32_t>(b), std::memory_order_relaxed))
        return;
    }
  }

  bool
  isRoot(std::size_t number) const
  {
    return load(number) == number;
  }

  /** \brief Number of sets. Linear. */
  std::size_t
  count() const
  {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parents_.size(); ++i)
      roots += isRoot(i) ? 1 : 0;
    return roots;
  }

private:
  std::size_t
  load(std::size_t number) const
  {
    return parents_[number].load(std::memory_order_relaxed);
  }

  std::vector<std::atomic<std::uint32_t>> parents_;
};

} // namespace pcl::ccaa
