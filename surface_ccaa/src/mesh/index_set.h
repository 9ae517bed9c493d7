// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a few indices out of many, in the order in which they came.
#pragma once

#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief A set of indices that numbers them as they come. Adding and finding one takes
 * a few ns; memory 12 to 20 bytes each. */
class IndexSet {
public:
  IndexSet() : slots_(FEWEST_SLOTS, -1) {}

  explicit IndexSet(const std::vector<pcl::index_t>& items) : IndexSet()
  {
    for (const pcl::index_t item : items)
      insert(item);
  }

  /** \return whether it is new */
  bool
  insert(pcl::index_t item)
  {
    std::size_t slot = slotOf(item);
    if (slots_[slot] >= 0)
      return false;
    if (2 * items_.size() >= slots_.size()) {
      grow();
      slot = slotOf(item);
    }
    slots_[slot] = static_cast<pcl::index_t>(items_.size());
    items_.push_back(item);
    return true;
  }

  /** \brief How many came before it, -1 if it is not there. */
  pcl::index_t
  placeOf(pcl::index_t item) const
  {
    return slots_[slotOf(item)];
  }

  bool
  contains(pcl::index_t item) const
  {
    return placeOf(item) >= 0;
  }

  std::size_t
  size() const
  {
    return items_.size();
  }

  /** \brief In the order in which they came. */
  const std::vector<pcl::index_t>&
  items() const
  {
    return items_;
  }

private:
  /** As many as three rings of triangles need are had by growing once. */
  static constexpr std::size_t FEWEST_SLOTS = 64;

  /** Where it is, else where it would be: the first free slot from its own. */
  std::size_t
  slotOf(pcl::index_t item) const
  {
    const std::size_t last = slots_.size() - 1;
    // Neighbors in space often have indices far apart by a power of two.
    std::size_t slot =
        static_cast<std::size_t>(
            (static_cast<std::uint64_t>(item) * 0x9e3779b97f4a7c15u) >> 32) &
        last;
    while (slots_[slot] >= 0 && items_[static_cast<std::size_t>(slots_[slot])] != item)
      slot = (slot + 1) & last;
    return slot;
  }

  void
  grow()
  {
    slots_.assign(4 * slots_.size(), -1);
    for (std::size_t i = 0; i < items_.size(); ++i)
      slots_[slotOf(items_[i])] = static_cast<pcl::index_t>(i);
  }

  std::vector<pcl::index_t> items_;
  std::vector<pcl::index_t> slots_; /**< places of items, -1 free; a power of two */
};

} // namespace pcl::ccaa
