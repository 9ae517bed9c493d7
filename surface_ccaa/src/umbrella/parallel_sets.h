// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: union-find that several threads fill at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Sets of the numbers [0, count), without locks.
 *
 * A root is always the lowest number of its set, so the final sets and roots do not
 * depend on who joined what first. Parents only ever move towards the root, which is
 * why relaxed order is enough: a stale parent is a longer way, not a wrong one. */
class ParallelSets {
public:
  using Number = std::uint32_t;

  /** \brief Sets of nothing; each number is to be given by makeSet() first. */
  explicit ParallelSets(std::size_t count) : parents_(count) {}

  void
  makeSet(Number number)
  {
    parents_[number].store(number, std::memory_order_relaxed);
  }

  /** \brief Root of the set of a number; halves the way on its way. */
  Number
  find(Number number)
  {
    Number parent = load(number);
    while (parent != number) {
      const Number grandparent = load(parent);
      if (grandparent == parent)
        return parent;
      parents_[number].store(grandparent, std::memory_order_relaxed);
      number = grandparent;
      parent = load(number);
    }
    return number;
  }

  void
  join(Number a, Number b)
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
      Number expected = a;
      if (parents_[a].compare_exchange_strong(expected, b, std::memory_order_relaxed))
        return;
    }
  }

private:
  Number
  load(Number number) const
  {
    return parents_[number].load(std::memory_order_relaxed);
  }

  std::vector<std::atomic<Number>> parents_;
};

} // namespace ccaa
} // namespace pcl
