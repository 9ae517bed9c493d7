// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: union-find for labels that may be turned against each
// other.
#pragma once

#include <pcl/types.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Sets of labels; every label knows whether it is turned against its parent.
 * The parent of a label is always lower, so the root of a set is its lowest label. */
class LabelSets {
public:
  pcl::index_t
  add()
  {
    links_.push_back(2 * static_cast<pcl::index_t>(links_.size()));
    return links_.back();
  }

  /** \brief Number of labels. */
  std::size_t
  size() const
  {
    return links_.size();
  }

  /** \brief A state (2 * label + turned) said by the root of its label. */
  pcl::index_t
  find(pcl::index_t state)
  {
    for (;;) {
      const auto label = static_cast<std::size_t>(state >> 1);
      const pcl::index_t up = links_[label];
      if ((up ^ state) <= 1)
        return state;
      // Path halving: the label skips its parent.
      links_[label] = links_[static_cast<std::size_t>(up >> 1)] ^ (up & 1);
      state = links_[label] ^ (state & 1);
    }
  }

  /** \brief Say that two states are the same.
   * \return false when that contradicts what was said before */
  bool
  join(pcl::index_t a, pcl::index_t b)
  {
    a = find(a);
    b = find(b);
    if ((a ^ b) <= 1)
      return a == b;
    const pcl::index_t low = std::min(a, b), high = std::max(a, b);
    links_[static_cast<std::size_t>(high >> 1)] = low ^ (high & 1);
    return true;
  }

  /** \brief Append another's sets. \return what to add to its states */
  pcl::index_t
  append(const LabelSets& other)
  {
    const auto shift = 2 * static_cast<pcl::index_t>(links_.size());
    for (const pcl::index_t link : other.links_)
      links_.push_back(link + shift);
    return shift;
  }

  /** \brief State of the parent that is the same as this label, not turned. */
  pcl::index_t
  link(std::size_t label) const
  {
    return links_[label];
  }

private:
  std::vector<pcl::index_t> links_;
};

} // namespace pcl::ccaa
