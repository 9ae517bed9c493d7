// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: union-find.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Sets of the numbers 0 to count - 1; the root of a set is its lowest member.
 */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parents_(count)
  {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
  }

  std::size_t
  find(std::size_t member)
  {
    while (parents_[member] != member) {
      parents_[member] = parents_[parents_[member]];
      member = parents_[member];
    }
    return member;
  }

  void
  join(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    if (a > b)
      std::swap(a, b);
    parents_[b] = static_cast<std::uint32_t>(a);
  }

  bool
  isRoot(std::size_t member) const
  {
    return parents_[member] == member;
  }

private:
  std::vector<std::uint32_t> parents_;
};

} // namespace ccaa
} // namespace pcl
